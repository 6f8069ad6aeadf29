// SPDX-License-Identifier: BSD-3-Clause
#include <pinocchio/algorithm/center-of-mass.hpp>
#include <pinocchio/algorithm/centroidal.hpp>
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <pinocchio/algorithm/kinematics.hpp>
#include <pinocchio/serialization.hpp>

#include "symbolic/robot_symbols.hpp"

namespace surefoot::symbolic {

namespace {

constexpr auto kWorldAligned = pinocchio::LOCAL_WORLD_ALIGNED;

Model load(const std::string& text) {
  pinocchio::Model model;
  model.loadFromString(text);
  return model.cast<SX>();
}

}  // namespace

RobotSymbols::RobotSymbols(const std::string& text, const std::array<int, 4>& feet_)
    : model(load(text)),
      data(model),
      feet(feet_),
      q(SX::sym("q", model.nq)),
      v(SX::sym("v", model.nv)),
      a(SX::sym("a", model.nv)),
      tau(SX::sym("tau", model.nv)) {}

SX RobotSymbols::foot_positions() {
  pinocchio::framesForwardKinematics(model, data, to_eigen(q));
  std::vector<SX> columns;
  for (const int foot : feet) columns.push_back(to_casadi(data.oMf[foot].translation()));
  return SX::horzcat(columns);
}

SX RobotSymbols::foot_jacobian() {
  pinocchio::computeJointJacobians(model, data, to_eigen(q));
  std::vector<SX> rows;
  for (const int foot : feet) {
    Eigen::Matrix<SX, 6, Eigen::Dynamic> J(6, model.nv);
    J.setZero();
    pinocchio::getFrameJacobian(model, data, foot, kWorldAligned, J);
    rows.push_back(to_casadi(J.topRows<3>()));
  }
  return SX::vertcat(rows);
}

SX RobotSymbols::foot_drifts() {
  const VectorX zero_acceleration = VectorX::Zero(model.nv);
  pinocchio::forwardKinematics(model, data, to_eigen(q), to_eigen(v), zero_acceleration);
  std::vector<SX> columns;
  for (const int foot : feet) {
    const auto drift = pinocchio::getFrameClassicalAcceleration(model, data, foot, kWorldAligned);
    columns.push_back(to_casadi(Vector3(drift.linear())));
  }
  return SX::horzcat(columns);
}

SX RobotSymbols::center_of_mass() {
  return to_casadi(pinocchio::centerOfMass(model, data, to_eigen(q)));
}

SX RobotSymbols::centroidal_matrix() {
  return to_casadi(pinocchio::computeCentroidalMap(model, data, to_eigen(q)));
}

SX RobotSymbols::tangent_derivative(const SX& value) {
  MatrixX map = MatrixX::Zero(model.nq, model.nv);
  pinocchio::tangentMap(model, to_eigen(q), map);
  return SX::mtimes(SX::jacobian(value, q), to_casadi(map));
}

}  // namespace surefoot::symbolic
