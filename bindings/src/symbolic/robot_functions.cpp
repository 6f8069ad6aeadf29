// SPDX-License-Identifier: BSD-3-Clause
#include "symbolic/robot_functions.hpp"

#include "symbolic/scalar.hpp"

// After the scalar's header, which CasADi's support in Pinocchio needs to be the first.
#include <functional>
#include <map>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/center-of-mass.hpp>
#include <pinocchio/algorithm/centroidal.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <pinocchio/algorithm/kinematics.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/serialization.hpp>
#include <stdexcept>

namespace surefoot::symbolic {

namespace {

using casadi::Function;

constexpr auto kWorldAligned = pinocchio::LOCAL_WORLD_ALIGNED;

Model load(const std::string& text) {
  pinocchio::Model model;
  model.loadFromString(text);
  return model.cast<SX>();
}

// The model with a symbol for each of its variables, as CasADi and as Eigen have them.
struct Robot {
  Robot(const std::string& text, const std::array<int, 4>& feet_)
      : model(load(text)),
        data(model),
        feet(feet_),
        q(SX::sym("q", model.nq)),
        v(SX::sym("v", model.nv)),
        a(SX::sym("a", model.nv)),
        tau(SX::sym("tau", model.nv)) {}

  SX mass_matrix() {
    return SX::triu2symm(SX::triu(
        to_casadi(pinocchio::crba(model, data, to_eigen(q), pinocchio::Convention::WORLD))));
  }
  SX bias() {
    return to_casadi(pinocchio::nonLinearEffects(model, data, to_eigen(q), to_eigen(v)));
  }
  SX inverse_dynamics() {
    return to_casadi(pinocchio::rnea(model, data, to_eigen(q), to_eigen(v), to_eigen(a)));
  }
  SX forward_dynamics() {
    return to_casadi(pinocchio::aba(model, data, to_eigen(q), to_eigen(v), to_eigen(tau),
                                    pinocchio::Convention::LOCAL));
  }
  SX foot_positions();
  SX foot_jacobian();
  SX foot_drifts();
  SX center_of_mass() { return to_casadi(pinocchio::centerOfMass(model, data, to_eigen(q))); }
  SX centroidal_matrix() {
    return to_casadi(pinocchio::computeCentroidalMap(model, data, to_eigen(q)));
  }
  // By the chain rule from the change of q that a tangent vector makes.
  SX by_tangent(const SX& value) {
    MatrixX map = MatrixX::Zero(model.nq, model.nv);
    pinocchio::tangentMap(model, to_eigen(q), map);
    return SX::mtimes(SX::jacobian(value, q), to_casadi(map));
  }

  Model model;
  Data data;
  std::array<int, 4> feet;
  SX q, v, a, tau;
};

SX Robot::foot_positions() {
  pinocchio::framesForwardKinematics(model, data, to_eigen(q));
  std::vector<SX> columns;
  for (const int foot : feet) columns.push_back(to_casadi(data.oMf[foot].translation()));
  return SX::horzcat(columns);
}

SX Robot::foot_jacobian() {
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

SX Robot::foot_drifts() {
  const VectorX still = VectorX::Zero(model.nv);
  pinocchio::forwardKinematics(model, data, to_eigen(q), to_eigen(v), still);
  std::vector<SX> columns;
  for (const int foot : feet) {
    const auto drift = pinocchio::getFrameClassicalAcceleration(model, data, foot, kWorldAligned);
    columns.push_back(to_casadi(Vector3(drift.linear())));
  }
  return SX::horzcat(columns);
}

using Names = std::vector<std::string>;
using Columns = std::vector<SX>;

Function of_q(Robot& r, const SX& out, const std::string& name) {
  return {name, Columns{r.q}, Columns{SX::densify(out)}, Names{"q"}, Names{name}};
}

Function of_q_v(Robot& r, const SX& out, const std::string& name) {
  return {name, Columns{r.q, r.v}, Columns{SX::densify(out)}, Names{"q", "v"}, Names{name}};
}

// The variable after q and v.
struct Last {
  SX symbol;
  std::string name;
};

Function of_motion(Robot& r, const Last& last, const SX& out, const std::string& name) {
  return {name, Columns{r.q, r.v, last.symbol}, Columns{SX::densify(out)},
          Names{"q", "v", last.name}, Names{name}};
}

// Of the function of q, v and one more whose expression `out` is.
Function derivatives(Robot& r, const Last& last, const SX& out, const std::string& name) {
  const Columns parts = {SX::densify(r.by_tangent(out)), SX::densify(SX::jacobian(out, r.v)),
                         SX::densify(SX::jacobian(out, last.symbol))};
  return {name, Columns{r.q, r.v, last.symbol}, parts, Names{"q", "v", last.name},
          Names{"by_q", "by_v", "by_" + last.name}};
}

using Maker = std::function<Function(Robot&, const std::string& name)>;

const std::map<std::string, Maker>& makers() {
  using N = const std::string&;
  static const std::map<std::string, Maker> table = {
      {"mass_matrix", [](Robot& r, N n) { return of_q(r, r.mass_matrix(), n); }},
      {"bias", [](Robot& r, N n) { return of_q_v(r, r.bias(), n); }},
      {"foot_positions", [](Robot& r, N n) { return of_q(r, r.foot_positions(), n); }},
      {"foot_jacobian", [](Robot& r, N n) { return of_q(r, r.foot_jacobian(), n); }},
      {"foot_drifts", [](Robot& r, N n) { return of_q_v(r, r.foot_drifts(), n); }},
      {"center_of_mass", [](Robot& r, N n) { return of_q(r, r.center_of_mass(), n); }},
      {"centroidal_matrix", [](Robot& r, N n) { return of_q(r, r.centroidal_matrix(), n); }},
      {"centroidal_momentum",
       [](Robot& r, N n) { return of_q_v(r, SX::mtimes(r.centroidal_matrix(), r.v), n); }},
      {"inverse_dynamics",
       [](Robot& r, N n) { return of_motion(r, {r.a, "a"}, r.inverse_dynamics(), n); }},
      {"forward_dynamics",
       [](Robot& r, N n) { return of_motion(r, {r.tau, "tau"}, r.forward_dynamics(), n); }},
      {"inverse_dynamics_derivatives",
       [](Robot& r, N n) { return derivatives(r, {r.a, "a"}, r.inverse_dynamics(), n); }},
      {"forward_dynamics_derivatives",
       [](Robot& r, N n) { return derivatives(r, {r.tau, "tau"}, r.forward_dynamics(), n); }},
  };
  return table;
}

}  // namespace

std::string robot_function(const std::string& model, const std::array<int, 4>& feet,
                           const std::string& name) {
  const auto maker = makers().find(name);
  if (maker == makers().end()) throw std::invalid_argument("no function named '" + name + "'");
  Robot robot(model, feet);
  return maker->second(robot, name).serialize();
}

}  // namespace surefoot::symbolic
