// SPDX-License-Identifier: BSD-3-Clause
// From a .robot file to torques, as on the robot's computer. Write the file first:
//   surefoot export go1 go1.robot
#include <cstdio>
#include <surefoot/surefoot.hpp>

int main(int argc, char** argv) {
  const surefoot::Robot robot = surefoot::Robot::load(argc > 1 ? argv[1] : "go1.robot");
  surefoot::StandController controller(robot);

  // On the robot, udp.GetRecv(state) reads the LowState. This one is at rest in the standing pose.
  surefoot::LowState state = surefoot::init_low_state();
  state.imu.quaternion = {1.0F, 0.0F, 0.0F, 0.0F};
  state.imu.accelerometer = {0.0F, 0.0F, 9.81F};
  for (int i = 0; i < surefoot::kMotors; ++i) {
    state.motorState[i].q = static_cast<float>(robot.config().q_standing[i]);
  }
  state.tick = 1;

  const surefoot::LowCmd command = controller.update(state);
  std::printf("%s:", surefoot::to_string(controller.status()));
  for (int i = 0; i < surefoot::kMotors; ++i) {
    const float tau = command.motorCmd[i].tau;  // packed field: copy it, do not bind a reference
    std::printf(" %.2f", static_cast<double>(tau));
  }
  std::printf(" N.m\n");
  return controller.status() == surefoot::Status::kOk ? 0 : 1;
}
