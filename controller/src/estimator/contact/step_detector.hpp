// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "surefoot/math.hpp"

namespace surefoot {

/// Tells from the contacts alone whether the robot steps, for logs of robots with other
/// controllers.
///
/// The robot steps if two touchdowns within a second are not one impact. A foot that somebody lifts
/// and drops is no step, and neither is a robot that is dropped on four feet. A robot counts as at
/// rest from the first sample until a foot swings. Real-time: yes.
class StepDetector {
 public:
  /// Process one tick.
  /// @param contact contact confidence of each foot, 0 .. 1
  void update(const Eigen::Vector4d& contact, double dt) noexcept;

  bool steps() const noexcept;
  /// Return whether all feet have stood long enough for the vibration of an impact to decay.
  bool rests() const noexcept;
  void reset() noexcept { *this = StepDetector(); }

 private:
  // [s] Times since the last touchdown, and since the touchdown before it.
  double last_ = std::numeric_limits<double>::infinity();
  double second_last_ = std::numeric_limits<double>::infinity();
  double rest_time_ = std::numeric_limits<double>::infinity();  // [s] for which all feet stand
  std::array<double, kLegs> air_time_{};  // [s] for which a foot has been off the ground
};

}  // namespace surefoot
