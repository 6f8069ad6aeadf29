// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <casadi/casadi.hpp>
#include <string>
#include <vector>

namespace surefoot::symbolic {

/// A part of the results.
struct Field {
  std::string name, meaning;
  int first;  ///< its first entry's index
};

/// The dynamics of one leg on a free base as expressions; every member is a column.
///
/// Base axes at the base's origin are the inertial frame, so that the base's own configuration
/// drops out; only what Dynamics keeps in world axes is turned by R_world_base at the end. Matrices
/// are stored by columns, of symmetric ones the upper triangle.
struct LegExpressions {
  /// Of joint hip, thigh, calf: translation, then mass, lever, inertia (xx xy yy xz yz zz) of the
  /// body behind it, armature; at the end the foot in the calf's axes.
  casadi::SX parameters;
  /// The same for every leg: v, w (base axes), R_world_base, gravity, lever (base axes; the foot's
  /// radius times the ground's normal).
  casadi::SX base;
  casadi::SX leg;  ///< cos and sin of hip, thigh, calf; their velocities
  std::vector<casadi::SX> results;
  std::vector<Field> fields;  ///< of the results, in their order
  int summed_count;           ///< so many results from the first on are added up over the legs
};

/// Run Pinocchio's crba and nonLinearEffects on a leg of hip x, thigh y, calf y, no placement
/// turned.
LegExpressions leg_expressions();

}  // namespace surefoot::symbolic
