// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "surefoot/gains.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Return the planned load of a foot, 0 .. 1; 0 for a swing foot. Real-time: yes.
inline double planned_load(const FootReference& foot) noexcept {
  return foot.stance ? std::clamp(foot.load, 0.0, 1.0) : 0.0;
}

/// Return the contact confidence that the force limits of a foot assume, 0 .. 1. Real-time: yes.
inline double assumed_contact(double contact, const FootReference& foot) noexcept {
  return std::clamp(std::max(contact, foot.min_contact), 0.0, 1.0);
}

/// Compute the largest normal force of each foot [N], FR FL RR RL:
///   weight * planned load * (lost + contact (max - lost))
/// with the gains max = force_max_contact and lost = force_lost_contact.
///
/// The limit is 0 for a swing foot. For a stance foot with a planned load it is positive even at a
/// contact confidence of 0: a foot that is wrongly estimated as lifted must be able to carry load,
/// so that the estimator can detect the contact. Real-time: yes.
/// @param weight weight of the robot [N]
/// @param contact contact confidence of each foot, 0 .. 1, FR FL RR RL
Eigen::Vector4d normal_force_limits(const Gains& gains, double weight,
                                    const Eigen::Vector4d& contact,
                                    const Reference& reference) noexcept;

/// Compute the share of its even load that each foot may carry, 0 .. 1, FR FL RR RL:
///   planned load * (share_lost_contact + contact (1 - share_lost_contact))
/// Real-time: yes.
Eigen::Vector4d load_shares(const Gains& gains, const Eigen::Vector4d& contact,
                            const Reference& reference) noexcept;

}  // namespace surefoot
