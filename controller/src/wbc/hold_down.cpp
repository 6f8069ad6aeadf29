// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/hold_down.hpp"

#include <algorithm>

#include "tasks/foot_loads.hpp"

namespace surefoot {

Eigen::Vector4d hold_down_forces(const Gains& gains, double weight, double fade,
                                 const Eigen::Vector4d& contact,
                                 const Reference& reference) noexcept {
  const bool one_swings = std::count_if(reference.feet.begin(), reference.feet.end(),
                                        [](const FootReference& foot) { return foot.stance; }) == 3;
  const double share = reference.stepping && one_swings ? gains.walk_hold_down : gains.hold_down;
  Eigen::Vector4d forces;
  for (int leg = 0; leg < kLegs; ++leg) {
    const double load = planned_load(reference.feet[leg]);
    const double confidence = assumed_contact(contact[leg], reference.feet[leg]);
    forces[leg] = share * weight * fade * load * confidence;
  }
  return forces;
}

}  // namespace surefoot
