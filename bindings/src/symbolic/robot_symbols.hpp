// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "symbolic/scalar.hpp"

namespace surefoot::symbolic {

/// A model with a symbol for each of its variables, and what Pinocchio's algorithms make of them.
///
/// The members are spread over two files: each algorithm on CasADi scalars costs the compiler a
/// gigabyte.
struct RobotSymbols {
  /// @param text of Robot::serialized_model()
  /// @param feet frame ids FR FL RR RL
  RobotSymbols(const std::string& text, const std::array<int, 4>& feet);

  // robot_dynamics.cpp
  SX mass_matrix();
  SX bias();
  SX inverse_dynamics();
  SX forward_dynamics();

  // robot_kinematics.cpp
  SX foot_positions();
  SX foot_jacobian();
  SX foot_drifts();
  SX center_of_mass();
  SX centroidal_matrix();
  /// d(value)/dq by the chain rule from the change of q that a tangent vector makes.
  SX tangent_derivative(const SX& value);

  Model model;
  Data data;
  std::array<int, 4> feet;
  SX q, v, a, tau;
};

}  // namespace surefoot::symbolic
