// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <proxsuite/linalg/dense/core.hpp>

// Replaces one function of ProxSuite 0.8.0, so that QpSolver::solve() allocates nothing, as the
// documentation of QpSolver promises.
// The LDLT update of ProxSuite computes
//   dst += (factor * lhs) * rhs
// with dynamic sizes. If dst has one row, Eigen evaluates `factor * lhs` into a heap vector: a few
// mallocs in 20 000 ticks. The loops below compute the same product without allocation, and are as
// fast at this size. Include this file before the solver.
namespace proxsuite::linalg::dense::_detail {

using StridedMap = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>,
                              Eigen::Unaligned, Eigen::Stride<Eigen::Dynamic, 1>>;
using ConstStridedMap = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>,
                                   Eigen::Unaligned, Eigen::Stride<Eigen::Dynamic, 1>>;

template <>
inline void noalias_mul_add_impl<StridedMap, ConstStridedMap, ConstStridedMap, double>(
    StridedMap dst, ConstStridedMap lhs, ConstStridedMap rhs, double factor) {
  for (Eigen::Index column = 0; column < dst.cols(); ++column) {
    for (Eigen::Index k = 0; k < lhs.cols(); ++k) {
      const double scale = factor * rhs(k, column);
      for (Eigen::Index row = 0; row < dst.rows(); ++row) dst(row, column) += scale * lhs(row, k);
    }
  }
}

}  // namespace proxsuite::linalg::dense::_detail
