// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

namespace surefoot::symbolic {

/// One of the functions of bindings/surefoot/symbolic.py, of which `name` is the name there, as
/// casadi::Function::serialize() writes it.
///
/// @param model text of Robot::serialized_model()
/// @param feet frame ids FR FL RR RL
/// Throws std::invalid_argument for a name that does not exist.
std::string robot_function(const std::string& model, const std::array<int, 4>& feet,
                           const std::string& name);

}  // namespace surefoot::symbolic
