// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "surefoot/math.hpp"

namespace surefoot {

/// Tells whether the robot steps: from its planner, or from the contacts alone, for logs of robots
/// with other controllers.
///
/// By its contacts the robot steps if two touchdowns within a second are not one impact. A foot
/// that somebody lifts and drops is no step, and neither is a robot that is dropped on four feet. A
/// robot counts as at rest from the first sample until a foot swings. Real-time: yes.
class StepDetector {
 public:
  /// Process one tick.
  /// @param contact contact confidence of each foot, 0 .. 1
  void update(const Eigen::Vector4d& contact, double dt) noexcept;

  /// Set whether the planner lets feet step.
  void set_planned(bool planned) noexcept { planned_ = planned; }
  bool planned() const noexcept { return planned_; }
  /// Return whether the robot steps, by its planner or by its contacts.
  bool steps() const noexcept;
  /// Return whether the robot steps, or its soles may still sink after the last step.
  bool stepped_lately() const noexcept;
  /// Return whether no step is planned, and all feet have stood long enough for the vibration of an
  /// impact to decay.
  bool rests() const noexcept;
  void reset() noexcept { *this = StepDetector(); }

 private:
  // [s] Times since the last touchdown, and since the touchdown before it.
  double last_ = std::numeric_limits<double>::infinity();
  double second_last_ = std::numeric_limits<double>::infinity();
  double rest_time_ = std::numeric_limits<double>::infinity();  // [s] for which all feet stand
  double time_since_steps_ = std::numeric_limits<double>::infinity();  // [s]
  bool planned_ = false;
  std::array<double, kLegs> air_time_{};  // [s] for which a foot has been off the ground
};

}  // namespace surefoot
