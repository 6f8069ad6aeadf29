// SPDX-License-Identifier: BSD-3-Clause
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>

#include "symbolic/robot_symbols.hpp"

namespace surefoot::symbolic {

SX RobotSymbols::mass_matrix() {
  return SX::triu2symm(
      SX::triu(to_casadi(pinocchio::crba(model, data, to_eigen(q), pinocchio::Convention::WORLD))));
}

SX RobotSymbols::bias() {
  return to_casadi(pinocchio::nonLinearEffects(model, data, to_eigen(q), to_eigen(v)));
}

SX RobotSymbols::inverse_dynamics() {
  return to_casadi(pinocchio::rnea(model, data, to_eigen(q), to_eigen(v), to_eigen(a)));
}

SX RobotSymbols::forward_dynamics() {
  return to_casadi(pinocchio::aba(model, data, to_eigen(q), to_eigen(v), to_eigen(tau),
                                  pinocchio::Convention::LOCAL));
}

}  // namespace surefoot::symbolic
