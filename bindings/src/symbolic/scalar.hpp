// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The CasADi header must come before every other one of Pinocchio.
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

/// CasADi's matrix of an Eigen matrix of CasADi scalars. (Pinocchio's own copy keeps zeros as
/// entries; here what is zero by structure stays sparse.)
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

/// The scalars of a CasADi column, as Eigen.
inline VectorX to_eigen(const SX& column) {
  VectorX out(column.size1());
  for (Eigen::Index i = 0; i < out.size(); ++i) out[i] = column(i);
  return out;
}

}  // namespace surefoot::symbolic
