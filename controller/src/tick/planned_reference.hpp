// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "surefoot/math.hpp"
#include "surefoot/planner.hpp"
#include "surefoot/robot.hpp"

namespace surefoot {

/// Calls the planner, checks what it wrote, and keeps the last valid reference.
///
/// The first reference that the planner receives is a default one with the standing pose as
/// posture. So a planner can write the posture in place, and copies of a Reference do not allocate.
/// Real-time: all functions except the constructor, if the planner is.
class PlannedReference {
 public:
  /// Throws surefoot::Error if `planner` is null.
  PlannedReference(const Robot& robot, std::shared_ptr<Planner> planner);

  /// Let the planner write the reference of this tick. If it fails or the reference is invalid,
  /// keep the last valid reference, also as the start of the next plan.
  /// @return kOk or kBadReference
  Status plan(const PlannerInput& input) noexcept;

  /// Add accelerations to those of the feet, until the next plan(); world axes [m/s^2].
  void add_to_feet(const FeetMatrix& a) noexcept;

  /// Return whether a valid reference was planned since the last reset().
  bool has_reference() const noexcept { return has_reference_; }
  /// Return the last valid reference; before the first one, the default.
  const Reference& reference() const noexcept { return reference_; }

  /// Discard the reference, and reset the planner.
  void reset() noexcept;

 private:
  Robot robot_;
  std::shared_ptr<Planner> planner_;
  Reference initial_;
  Reference planned_;  // written by the planner
  Reference reference_;
  FeetMatrix added_ = FeetMatrix::Zero();  // [m/s^2] by add_to_feet(), part of reference_
  bool has_reference_ = false;
};

}  // namespace surefoot
