// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <casadi/casadi.hpp>
#include <string>
#include <vector>

namespace surefoot::generator {

/// One field of LegExpressions::results.
struct Field {
  std::string name, meaning;  ///< name of the constant in the generated code, and its comment
  int first;                  ///< index of the field's first entry in the results
};

/// Dynamics of one leg on a free base, as CasADi expressions; every member is a column.
///
/// The base frame is used as the inertial frame, so the expressions do not depend on the pose of
/// the base. Only results that Dynamics has in world axes are rotated by R_world_base at the end.
/// Matrices are stored by columns; of symmetric matrices only the upper triangle is stored.
struct LegExpressions {
  /// For hip, thigh and calf: translation of the joint; mass, lever and inertia (xx xy yy xz yz zz)
  /// of the body that the joint moves; armature. At the end: position of the foot in calf axes.
  casadi::SX parameters;
  /// State of the base, the same for every leg: v, w, R_world_base, gravity and lever. The lever is
  /// foot radius times ground normal. All vectors are in base axes.
  casadi::SX base;
  casadi::SX leg;  ///< cos and sin of hip, thigh, calf; then joint velocities [rad/s]
  std::vector<casadi::SX> results;  ///< entries of all fields, one after the other
  std::vector<Field> fields;        ///< fields of the results, in order
  int summed_count;  ///< number of results, from the first on, that are summed over the legs
};

/// Compute the expressions with Pinocchio's crba and nonLinearEffects. The leg has joint axes hip
/// x, thigh y, calf y, and no joint placement is rotated.
LegExpressions leg_expressions();

}  // namespace surefoot::generator
