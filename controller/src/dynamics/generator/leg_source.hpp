// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace surefoot::generator {

/// Return the text of controller/src/dynamics/generated/leg_dynamics.hpp.
std::string leg_source();

}  // namespace surefoot::generator
