// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/qp_problem.hpp"
#include "wbc/qp_layout.hpp"
#include "wbc/qp_terms.hpp"

namespace surefoot {

/// Write the rows of friction, normal force and hold-down. They are the same in both forms of the
/// QP.
/// @param first index of the first force in x
/// @param unit [N] unit of a force variable
/// Real-time: yes.
void write_force_rows(const QpTerms& terms, int first, double unit, QpProblem& out) noexcept;

}  // namespace surefoot
