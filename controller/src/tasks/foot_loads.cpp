// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/foot_loads.hpp"

namespace surefoot {

namespace {

// Interpolate from `without_contact` at contact confidence 0 to `with_contact` at contact
// confidence 1, and multiply the result by the planned load of the foot.
double scaled_by_contact(double without_contact, double with_contact, double contact,
                         const FootReference& foot) noexcept {
  const double share =
      without_contact + assumed_contact(contact, foot) * (with_contact - without_contact);
  return planned_load(foot) * share;
}

}  // namespace

Eigen::Vector4d normal_force_limits(const Gains& gains, double weight,
                                    const Eigen::Vector4d& contact,
                                    const Reference& reference) noexcept {
  Eigen::Vector4d limits;
  for (int leg = 0; leg < kLegs; ++leg) {
    limits[leg] = weight * scaled_by_contact(gains.force_lost_contact, gains.force_max_contact,
                                             contact[leg], reference.feet[leg]);
  }
  return limits;
}

Eigen::Vector4d load_shares(const Gains& gains, const Eigen::Vector4d& contact,
                            const Reference& reference) noexcept {
  Eigen::Vector4d shares;
  for (int leg = 0; leg < kLegs; ++leg) {
    shares[leg] =
        scaled_by_contact(gains.share_lost_contact, 1.0, contact[leg], reference.feet[leg]);
  }
  return shares;
}

}  // namespace surefoot
