// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/qp_problem.hpp"
#include "wbc/qp_layout.hpp"
#include "wbc/qp_terms.hpp"

namespace surefoot {

/// Write friction, normal force and hold-down: rows on the contact forces, alike in both forms.
/// @param first column of the forces in x @param unit [N] of a force variable
/// Real-time: yes.
void write_force_rows(const QpTerms& terms, int first, double unit, QpProblem& out) noexcept;

}  // namespace surefoot
