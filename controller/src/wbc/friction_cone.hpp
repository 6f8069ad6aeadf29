// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Facets of the friction pyramid. Inscribed, 14 lose at most 1 - cos(pi/14) = 2.5 % of the cone
/// in any direction; four would lose 29 % just where a push along an axis needs it.
constexpr int kFacets = 14;

using ConeRows = Eigen::Matrix<double, kFacets, 3>;

/// Rows of the inscribed pyramid: a force is inside when rows * f <= 0. Real-time: yes.
/// @param normal unit, out of the ground, world axes
ConeRows friction_cone(const Vector3& normal, double friction) noexcept;

}  // namespace surefoot
