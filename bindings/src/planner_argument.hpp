// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/nanobind.h>

#include <memory>

#include "surefoot/planner.hpp"

/// Convert the argument `planner` of Controller. Raises TypeError if it is no usable planner.
std::shared_ptr<surefoot::Planner> planner_argument(nanobind::handle value);
