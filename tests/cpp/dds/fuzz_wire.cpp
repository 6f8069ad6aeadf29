// SPDX-License-Identifier: BSD-3-Clause
// Feed random DDS messages to the conversions. Built with sanitizers, without Pinocchio and DDS.
// Usage: surefoot_dds_fuzz [MESSAGES [SEED]]
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <random>

#include "dds/wire/low_cmd_conversion.hpp"
#include "dds/wire/low_state_conversion.hpp"
#include "dds/wire/wire_crc.hpp"

using namespace surefoot;

namespace {

struct FuzzCounts {
  long messages = 0, accepted = 0, wrong = 0;
};

using Random = std::mt19937_64;

// Fill a message with random bytes, or change some bytes of one with zeros. Random floats are often
// NaN, so most messages have few changed bytes.
template <typename Wire>
void randomize(Wire& wire, Random& random) {
  auto* bytes = reinterpret_cast<std::uint8_t*>(&wire);
  std::memset(bytes, 0, sizeof(wire));
  const auto changes = random() % 16 == 0 ? sizeof(wire) : random() % 40;
  for (std::size_t k = 0; k < changes; ++k) {
    bytes[random() % sizeof(wire)] = static_cast<std::uint8_t>(random());
  }
  if (random() % 4 != 0) wire.crc = wire_crc(wire);
}

CrcRule random_rule(Random& random) {
  return random() % 2 == 0 ? CrcRule::kRequired : CrcRule::kZeroIsAbsent;
}
DdsRobot random_robot(Random& random) { return random() % 2 == 0 ? DdsRobot::kGo2 : DdsRobot::kB2; }

bool all_finite(const DdsLowCmd& cmd) {
  for (const DdsMotorCmd& m : cmd.motor_cmd) {
    for (const float x : {m.q, m.dq, m.tau, m.kp, m.kd}) {
      if (!std::isfinite(x)) return false;
    }
  }
  return true;
}

// A command that is accepted can be sent again, in servo mode, with a right CRC.
void fuzz_command(Random& random, FuzzCounts& counts) {
  const auto wire = std::make_unique<DdsLowCmd>();  // on the heap: overruns are detected
  randomize(*wire, random);
  const DdsRobot robot = random_robot(random);
  LowCmd read;
  if (!is_usable(from_dds(*wire, robot, random_rule(random), read).status)) return;
  ++counts.accepted;
  const auto again = std::make_unique<DdsLowCmd>();
  const bool sent = is_usable(to_dds(read, robot, 3.0, *again).status);
  bool right = sent && again->crc == wire_crc(*again) && all_finite(*again);
  right = right && again->bms_cmd.off == 0;
  for (const DdsMotorCmd& motor : again->motor_cmd) {
    right = right && motor.mode == (robot == DdsRobot::kGo2 ? 0x01 : 0x0A);
  }
  if (!right) ++counts.wrong;
}

// A LowState that is accepted is the same after another conversion to the wire and back.
void fuzz_state(Random& random, FuzzCounts& counts) {
  const auto wire = std::make_unique<DdsLowState>();
  randomize(*wire, random);
  const DdsRobot robot = random_robot(random);
  LowState read, again;
  if (!is_usable(from_dds(*wire, robot, random_rule(random), read).status)) return;
  ++counts.accepted;
  const auto sent = std::make_unique<DdsLowState>();
  const bool usable = is_usable(to_dds(read, robot, *sent).status) &&
                      is_usable(from_dds(*sent, robot, CrcRule::kRequired, again).status);
  again.crc = read.crc;
  if (!usable || std::memcmp(&again, &read, sizeof(read)) != 0) ++counts.wrong;
}

}  // namespace

int main(int argc, char** argv) {
  const long count = argc > 1 ? std::atol(argv[1]) : 1000000;
  Random random(argc > 2 ? static_cast<std::uint64_t>(std::atol(argv[2])) : 1);
  FuzzCounts counts;
  for (; counts.messages < count; ++counts.messages) {
    if (random() % 2 == 0) {
      fuzz_command(random, counts);
    } else {
      fuzz_state(random, counts);
    }
  }
  std::printf("%ld messages, %ld accepted, %ld wrong\n", counts.messages, counts.accepted,
              counts.wrong);
  return counts.wrong == 0 && counts.accepted > count / 4 ? 0 : 1;
}
