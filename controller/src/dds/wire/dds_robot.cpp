// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/dds_robot.hpp"

#include "surefoot/error.hpp"

namespace surefoot {

const char* to_string(DdsRobot robot) noexcept { return robot == DdsRobot::kGo2 ? "go2" : "b2"; }

DdsRobot to_dds_robot(const std::string& name) {
  for (const DdsRobot robot : {DdsRobot::kGo2, DdsRobot::kB2}) {
    if (name == to_string(robot)) return robot;
  }
  throw Error("DDS robot: got '" + name + "', expected one of go2, b2");
}

}  // namespace surefoot
