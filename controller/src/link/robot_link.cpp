// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/robot_link.hpp"

#include "common/clock.hpp"

namespace surefoot {

double RobotLink::state_age() const noexcept {
  const LinkStatus& now = status();
  return now.has_state ? monotonic_time() - now.arrival_time
                       : std::numeric_limits<double>::infinity();
}

}  // namespace surefoot
