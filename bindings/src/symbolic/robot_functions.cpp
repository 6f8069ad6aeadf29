// SPDX-License-Identifier: BSD-3-Clause
#include "symbolic/robot_functions.hpp"

#include <functional>
#include <map>
#include <stdexcept>
#include <vector>

#include "symbolic/robot_symbols.hpp"

namespace surefoot::symbolic {

namespace {

using casadi::Function;
using Names = std::vector<std::string>;
using Columns = std::vector<SX>;

Function function_of_q(RobotSymbols& r, const SX& out, const std::string& name) {
  return {name, Columns{r.q}, Columns{SX::densify(out)}, Names{"q"}, Names{name}};
}

Function function_of_q_v(RobotSymbols& r, const SX& out, const std::string& name) {
  return {name, Columns{r.q, r.v}, Columns{SX::densify(out)}, Names{"q", "v"}, Names{name}};
}

// Third input of a function, after q and v.
struct ThirdInput {
  SX symbol;
  std::string name;
};

Function function_of_motion(RobotSymbols& r, const ThirdInput& last, const SX& out,
                            const std::string& name) {
  return {name, Columns{r.q, r.v, last.symbol}, Columns{SX::densify(out)},
          Names{"q", "v", last.name}, Names{name}};
}

// Return the derivatives of `out`, an expression of q, v and a third input, with respect to these
// three inputs.
Function derivatives(RobotSymbols& r, const ThirdInput& last, const SX& out,
                     const std::string& name) {
  const Columns parts = {SX::densify(r.tangent_derivative(out)),
                         SX::densify(SX::jacobian(out, r.v)),
                         SX::densify(SX::jacobian(out, last.symbol))};
  return {name, Columns{r.q, r.v, last.symbol}, parts, Names{"q", "v", last.name},
          Names{"by_q", "by_v", "by_" + last.name}};
}

using FunctionMaker = std::function<Function(RobotSymbols&, const std::string& name)>;

const std::map<std::string, FunctionMaker>& function_makers() {
  using N = const std::string&;
  static const std::map<std::string, FunctionMaker> table = {
      {"mass_matrix", [](RobotSymbols& r, N n) { return function_of_q(r, r.mass_matrix(), n); }},
      {"bias", [](RobotSymbols& r, N n) { return function_of_q_v(r, r.bias(), n); }},
      {"foot_positions",
       [](RobotSymbols& r, N n) { return function_of_q(r, r.foot_positions(), n); }},
      {"foot_jacobian",
       [](RobotSymbols& r, N n) { return function_of_q(r, r.foot_jacobian(), n); }},
      {"foot_drifts", [](RobotSymbols& r, N n) { return function_of_q_v(r, r.foot_drifts(), n); }},
      {"center_of_mass",
       [](RobotSymbols& r, N n) { return function_of_q(r, r.center_of_mass(), n); }},
      {"centroidal_matrix",
       [](RobotSymbols& r, N n) { return function_of_q(r, r.centroidal_matrix(), n); }},
      {"centroidal_momentum",
       [](RobotSymbols& r, N n) {
         return function_of_q_v(r, SX::mtimes(r.centroidal_matrix(), r.v), n);
       }},
      {"inverse_dynamics",
       [](RobotSymbols& r, N n) {
         return function_of_motion(r, {r.a, "a"}, r.inverse_dynamics(), n);
       }},
      {"forward_dynamics",
       [](RobotSymbols& r, N n) {
         return function_of_motion(r, {r.tau, "tau"}, r.forward_dynamics(), n);
       }},
      {"inverse_dynamics_derivatives",
       [](RobotSymbols& r, N n) { return derivatives(r, {r.a, "a"}, r.inverse_dynamics(), n); }},
      {"forward_dynamics_derivatives",
       [](RobotSymbols& r, N n) {
         return derivatives(r, {r.tau, "tau"}, r.forward_dynamics(), n);
       }},
  };
  return table;
}

}  // namespace

std::string robot_function(const std::string& model, const std::array<int, 4>& feet,
                           const std::string& name) {
  const auto maker = function_makers().find(name);
  if (maker == function_makers().end())
    throw std::invalid_argument("name: got '" + name +
                                "', expected a function of surefoot.symbolic");
  RobotSymbols robot(model, feet);
  return maker->second(robot, name).serialize();
}

}  // namespace surefoot::symbolic
