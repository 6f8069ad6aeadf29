// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Number of facets of the friction pyramid. An inscribed pyramid with 14 facets loses at most 1 -
/// cos(pi/14) = 2.5 % of the friction in any direction; with four facets it would lose 29 %.
constexpr int kFacets = 14;

using ConeRows = Eigen::Matrix<double, kFacets, 3>;

/// Compute the rows of the friction pyramid inscribed in the cone: a force f is inside if rows * f
/// <= 0.
/// Real-time: yes.
/// @param normal unit vector out of the ground, world axes
/// @param friction coefficient
ConeRows friction_cone(const Vector3& normal, double friction) noexcept;

}  // namespace surefoot
