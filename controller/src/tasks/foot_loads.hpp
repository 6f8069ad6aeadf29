// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "surefoot/gains.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Share of a foot's load that it is meant to bear, 0 .. 1; none in swing. Real-time: yes.
inline double planned_load(const FootReference& foot) noexcept {
  return foot.stance ? std::clamp(foot.load, 0.0, 1.0) : 0.0;
}

/// Greatest normal force of each foot [N], FR FL RR RL. Real-time: yes.
///
/// It goes smoothly with the planned load and the belief that the foot is on the ground, never to
/// nothing while it is meant to stand: a foot wrongly believed lifted must be able to show its
/// load. 0 in swing.
Eigen::Vector4d normal_force_limits(const Gains& gains, double weight,
                                    const Eigen::Vector4d& contact,
                                    const Reference& reference) noexcept;

/// Share of the even load each foot is offered, 0 .. 1, by the same belief. Real-time: yes.
Eigen::Vector4d load_shares(const Gains& gains, const Eigen::Vector4d& contact,
                            const Reference& reference) noexcept;

}  // namespace surefoot
