// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

namespace surefoot::symbolic {

/// Return a function of surefoot.symbolic, as the text that casadi::Function::serialize() writes.
///
/// Throws std::invalid_argument if the name is unknown.
/// @param model text of Robot::serialized_model()
/// @param feet frame ids, FR FL RR RL
/// @param name name of the function in bindings/surefoot/symbolic.py
std::string robot_function(const std::string& model, const std::array<int, 4>& feet,
                           const std::string& name);

}  // namespace surefoot::symbolic
