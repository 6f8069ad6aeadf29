// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Pinocchio's CasADi header must come before all other headers of Pinocchio.
#include <pinocchio/autodiff/casadi.hpp>
#include <pinocchio/multibody.hpp>

namespace surefoot::symbolic {

using SX = casadi::SX;
using Model = pinocchio::ModelTpl<SX>;
using Data = pinocchio::DataTpl<SX>;
using VectorX = Eigen::Matrix<SX, Eigen::Dynamic, 1>;
using MatrixX = Eigen::Matrix<SX, Eigen::Dynamic, Eigen::Dynamic>;
using Vector3 = Eigen::Matrix<SX, 3, 1>;
using Matrix3 = Eigen::Matrix<SX, 3, 3>;

/// Convert an Eigen matrix of CasADi scalars to a CasADi matrix. Structural zeros stay sparse.
/// (Pinocchio's own conversion stores them as entries.)
template <typename Derived>
SX to_casadi(const Eigen::MatrixBase<Derived>& m) {
  SX out(m.rows(), m.cols());
  for (Eigen::Index j = 0; j < m.cols(); ++j) {
    for (Eigen::Index i = 0; i < m.rows(); ++i) {
      if (!m(i, j).is_zero()) out(i, j) = m(i, j);
    }
  }
  return out;
}

/// Convert a CasADi column to an Eigen vector of CasADi scalars.
inline VectorX to_eigen(const SX& column) {
  VectorX out(column.size1());
  for (Eigen::Index i = 0; i < out.size(); ++i) out[i] = column(i);
  return out;
}

}  // namespace surefoot::symbolic
