// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "symbolic/scalar.hpp"

namespace surefoot::symbolic {

/// CasADi symbols for the variables of a robot model, and the results of Pinocchio's algorithms as
/// expressions of these symbols. surefoot.symbolic documents the results.
///
/// The functions are defined in two files, because each algorithm on CasADi scalars takes a
/// gigabyte of memory to compile.
struct RobotSymbols {
  /// @param text text of Robot::serialized_model()
  /// @param feet frame ids, FR FL RR RL
  RobotSymbols(const std::string& text, const std::array<int, 4>& feet);

  // Defined in robot_dynamics.cpp.
  SX mass_matrix();
  SX bias();
  SX inverse_dynamics();
  SX forward_dynamics();

  // Defined in robot_kinematics.cpp.
  SX foot_positions();
  SX foot_jacobian();
  SX foot_drifts();
  SX center_of_mass();
  SX centroidal_matrix();
  /// Compute the derivative of `value` with respect to the tangent of q: d(value)/dq times the
  /// tangent map of q.
  SX tangent_derivative(const SX& value);

  Model model;
  Data data;
  std::array<int, 4> feet;  ///< frame ids, FR FL RR RL
  SX q, v, a, tau;          ///< symbols in Pinocchio's conventions; tau has nv entries
};

}  // namespace surefoot::symbolic
