// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <casadi/casadi.hpp>
#include <string>
#include <vector>

namespace surefoot::symbolic {

/// Field of the results.
struct Field {
  std::string name, meaning;
  int first;  ///< index of its first entry
};

/// Dynamics of one leg on a free base, as CasADi expressions; every member is a column.
///
/// The base frame is used as the inertial frame, so that the configuration of the base drops out.
/// Only results that Dynamics has in world axes are rotated by R_world_base at the end. Matrices
/// are stored by columns, symmetric matrices as their upper triangle.
struct LegExpressions {
  /// For hip, thigh and calf: translation of the joint; mass, lever and inertia (xx xy yy xz yz zz)
  /// of the body that it moves; armature. At the end: position of the foot in calf axes.
  casadi::SX parameters;
  /// State of the base, for every leg the same: v, w (base axes), R_world_base, gravity (base
  /// axes), and lever: foot radius times ground normal, base axes.
  casadi::SX base;
  casadi::SX leg;  ///< cos and sin of hip, thigh, calf; their velocities [rad/s]
  std::vector<casadi::SX> results;
  std::vector<Field> fields;  ///< fields of the results, in their order
  int summed_count;           ///< number of first results that are summed over the legs
};

/// Compute the expressions with Pinocchio's crba and nonLinearEffects. The leg has joint axes hip
/// x, thigh y, calf y, and no joint placement is rotated.
LegExpressions leg_expressions();

}  // namespace surefoot::symbolic
