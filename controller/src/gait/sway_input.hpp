// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/body_trajectory.hpp"
#include "gait/foot_contacts.hpp"
#include "gait/step_pattern.hpp"
#include "surefoot/planner.hpp"

namespace surefoot {

/// The parts of Stepping on which the sway depends.
struct StepState {
  const StepPattern& pattern;
  const GaitSize& size;
  const GaitClock& clock;
  const FootContacts& contacts;
  const BodyTrajectory& body;
  const FeetMatrix& footholds;  ///< [m] world frame
};

/// Return the input of BodySway: the coming swings and footholds of a walk. In a trot all swings
/// are infinitely late, because two feet have no support triangle. Real-time: yes.
BodySway::Input sway_input(const StepState& steps, const PlannerInput& input) noexcept;

}  // namespace surefoot
