// SPDX-License-Identifier: BSD-3-Clause
#include "robot_end.hpp"

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <cmath>
#include <thread>

#include "dds/link/topics.hpp"
#include "dds/wire/low_state_conversion.hpp"
#include "dds/wire/wire_crc.hpp"

namespace surefoot {

void pause(int milliseconds) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

RobotEnd::RobotEnd(const DdsParticipant& participant)
    : writer(participant, unitree_go_msg_dds__LowState__desc, kStateTopic),
      reader(participant, unitree_go_msg_dds__LowCmd__desc, kCommandTopic) {}

void RobotEnd::send_state(std::uint32_t tick, bool with_crc) {
  LowState state = init_low_state();
  state.imu.quaternion = {1.0F, 0.0F, 0.0F, 0.0F};
  state.tick = tick;
  DdsLowState wire;
  to_dds(state, DdsRobot::kGo2, wire);
  if (!with_crc) wire.crc = 0;
  BOOST_REQUIRE(writer.write(&wire) == 0);
}

double RobotEnd::tau() {
  DdsLowCmd cmd;
  double tau = INFINITY;
  while (reader.take(&cmd)) {
    BOOST_TEST(cmd.crc == wire_crc(cmd));
    for (const DdsMotorCmd& motor : cmd.motor_cmd) BOOST_TEST(motor.mode == 0x01);
    tau = cmd.motor_cmd[0].kd > 0.0F ? NAN : cmd.motor_cmd[0].tau;
  }
  return tau;
}

ReliableReader::ReliableReader(const DdsParticipant& participant,
                               const dds_topic_descriptor_t& type, const char* topic) {
  const ddsc::Functions& f = participant.functions();
  topic_ =
      DdsEntity(f, f.create_topic(participant.handle(), &type, topic, nullptr, nullptr), topic);
  ddsc::Qos* const qos = f.create_qos();
  f.qset_reliability(qos, ddsc::Reliability::kReliable, 0);
  reader_ = DdsEntity(f, f.create_reader(participant.handle(), topic_.handle(), qos, nullptr),
                      "reliable reader");
  f.delete_qos(qos);
}

}  // namespace surefoot
