// SPDX-License-Identifier: BSD-3-Clause
// Fixture of the tests of DdsLink.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "dds_environment.hpp"
#include "robot_end.hpp"
#include "surefoot/dds_link.hpp"

namespace surefoot {

/// A link and the robot at its other end.
struct LinkFixture {
  std::shared_ptr<DdsNetwork> network = test_network();
  RobotEnd robot{network->participant()};
  DdsLink link{network, options()};
  LowCmd torque_command = init_low_cmd();
  LinkFixture() { torque_command.motorCmd[0].tau = 1.0F; }
  static DdsLinkOptions options() {
    DdsLinkOptions o;
    o.discovery_time = 0.2;
    return o;
  }
  bool receive() {
    return wait_until([this] { return link.receive(); });
  }
  double sent_tau() {
    link.send(torque_command);
    pause(5);
    return robot.tau();
  }
};

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline std::string all(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

}  // namespace surefoot
