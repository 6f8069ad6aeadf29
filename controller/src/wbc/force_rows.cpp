// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/force_rows.hpp"

#include "wbc/friction_cone.hpp"

namespace surefoot {

void write_force_rows(const QpTerms& terms, int first, double unit, QpProblem& out) noexcept {
  constexpr int kRows = QpLayout::kFootRows;
  const ConeRows full = friction_cone(terms.ground_normal, terms.friction.maxCoeff());
  for (int leg = 0; leg < kLegs; ++leg) {
    auto C = out.C.block<kRows, 3>(leg * kRows, first + 3 * leg);
    auto l = out.l.segment<kRows>(leg * kRows);
    auto u = out.u.segment<kRows>(leg * kRows);
    l.setConstant(-kNoBound);
    if (terms.normal_max[leg] > 0.0) {
      const bool less_friction = terms.friction[leg] < terms.friction.maxCoeff();
      const ConeRows cone =
          less_friction ? friction_cone(terms.ground_normal, terms.friction[leg]) : full;
      C << cone, terms.ground_normal.transpose();
      u.setZero();
      l[kFacets] = 0.0;
      u[kFacets] = terms.normal_max[leg] / unit;
    } else {
      // No contact force: three rows f = 0. A friction cone of height zero is not used: all its
      // facets would meet in one point, where the multipliers are not unique and the solver is
      // slow.
      C.setZero();
      C.topRows<3>().setIdentity();
      l.head<3>().setZero();
      u.setConstant(kNoBound);
      u.head<3>().setZero();
    }
    const int hold_down_row = QpLayout::kHard + leg;
    out.C.block<1, 3>(hold_down_row, first + 3 * leg) = terms.ground_normal.transpose();
    out.l[hold_down_row] = terms.hold_down[leg] > 0.0 ? terms.hold_down[leg] / unit : -kNoBound;
    out.u[hold_down_row] = kNoBound;
  }
}

}  // namespace surefoot
