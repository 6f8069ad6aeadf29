// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/foot_contacts.hpp"
#include "gait/step_pattern.hpp"
#include "gait/stumble.hpp"
#include "surefoot/planner.hpp"

namespace surefoot {

struct HorizontalMotion;
class BodyTrajectory;

/// When the feet step: the pattern of the gait, its clock, and the phases of the feet. Real-time:
/// yes.
class StepSchedule {
 public:
  explicit StepSchedule(const GaitSize& size) : size_(size) {}

  /// Begin with all feet on the ground.
  /// @param walk whether the robot walks with three feet down; false: it trots
  void start(const Gains& gains, bool walk, const WalkVelocity& command) noexcept;
  /// Begin with a trot in which the pair of `leg` lifts off at once.
  void start_recovery(const Gains& gains, int leg) noexcept;

  /// Change a walk to a trot at once. The pair of `leg` swings at once if no foot is in the air, or
  /// if the foot in the air belongs to it and is in the first half of its swing. Otherwise the foot
  /// in the air lands first, and the pair without it lifts off next. A foot that
  /// lifts over an obstacle also lands first.
  /// @param velocity of the body trajectory
  void trot_at_once(const Gains& gains, const WalkVelocity& velocity, int leg,
                    const Stumble& stumble) noexcept;
  /// Change the pattern when all feet stand: a trot becomes a walk, or a walk changes the order of
  /// its feet. The pattern stays until the body is slow.
  /// @param velocity of the body trajectory
  void update_pattern(const Gains& gains, bool walk, const WalkVelocity& command,
                      const WalkVelocity& velocity) noexcept;
  /// Advance clock and phases.
  /// @param measured measured motion of the body
  /// @param contact contact confidence per foot, 0 .. 1
  /// @param stop whether no further foot shall lift off
  void advance(const PlannerInput& input, const HorizontalMotion& measured,
               const BodyTrajectory& body, const Eigen::Vector4d& contact, const Stumble& stumble,
               bool stop) noexcept;

  /// Return whether the body must slow down before the pattern can change.
  bool needs_rest() const noexcept { return needs_rest_; }
  const StepPattern& pattern() const noexcept { return pattern_; }
  const GaitClock& clock() const noexcept { return clock_; }
  const FootContacts& contacts() const noexcept { return contacts_; }

 private:
  double longest_wait(const Stumble& stumble) const noexcept;  // [s] of the clock

  GaitSize size_;
  StepPattern pattern_;
  GaitClock clock_;
  FootContacts contacts_;
  bool needs_rest_ = false;  // the body slows down, so that the pattern can change
  bool stops_ = false;       // no foot lifts off until the pattern has changed
};

}  // namespace surefoot
