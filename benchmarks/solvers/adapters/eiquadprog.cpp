// SPDX-License-Identifier: BSD-3-Clause
// eiquadprog-fast, the Goldfarb-Idnani solver of TSID. Its inequalities are one-sided. Two-sided
// inequalities are split before timing, because a user would write one-sided inequalities.
#include <cmath>
#include <eiquadprog/eiquadprog-fast.hpp>

#include "adapter.hpp"

namespace bench {

namespace {

namespace ei = eiquadprog::solvers;
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

class Eiquadprog : public Adapter {
 public:
  explicit Eiquadprog(const Setup& s) : setup_(s), minus_b_(s.n_eq), x_(s.n) {
    x_.setZero();
    solver_.reset(s.n, s.n_eq, 2 * s.n_in);
  }

  Description describe() const override {
    return {"eiquadprog", "c++", PEER_VERSION, "EiquadprogFast, exact up to rounding: no tolerance",
            "none"};
  }
  bool can_warm_start() const override { return false; }
  void clear_warm_start() override {}
  void load_problem(const Problem& p) override {
    H_ = Eigen::Map<const RowMatrix>(p.H, p.n, p.n);
    A_ = Eigen::Map<const RowMatrix>(p.A, p.n_eq, p.n);
    C_ = Eigen::Map<const RowMatrix>(p.C, p.n_in, p.n);
    g_ = Eigen::Map<const Eigen::VectorXd>(p.g, p.n);
    b_ = Eigen::Map<const Eigen::VectorXd>(p.b, p.n_eq);
    l_ = Eigen::Map<const Eigen::VectorXd>(p.l, p.n_in);
    u_ = Eigen::Map<const Eigen::VectorXd>(p.u, p.n_in);
    minus_b_ = -b_;
    split_bounds();
  }
  SolveStatus solve() override {
    status_ = solver_.solve_quadprog(H_, g_, A_, minus_b_, CI_, ci_, x_);
    return status_ == ei::EIQUADPROG_FAST_OPTIMAL ? SolveStatus::kSolved : SolveStatus::kFailed;
  }
  int iterations() const override { return solver_.getIteratios(); }
  void read_solution(Solution& a) const override {
    a.x.assign(x_.begin(), x_.end());
    a.y.assign(a.y.size(), 0.0);
    a.z.assign(a.z.size(), 0.0);
    // The solver's inequalities are CI x + ci >= 0, so its multipliers have the opposite sign. Its
    // equalities have the numbers -1, -2 ...
    const auto& active = solver_.getActiveSet();
    const auto& u = solver_.getLagrangeMultipliers();
    for (std::size_t k = 0; k < solver_.getActiveSetSize(); ++k) {
      const int row = active[Eigen::Index(k)];
      const double multiplier = u[Eigen::Index(k)];
      if (row < 0) {
        a.y[-row - 1] = -multiplier;
      } else {
        a.z[source_row_[row]] += bound_sign_[row] * multiplier;
      }
    }
  }

 private:
  // Rows without a bound are omitted, so the number of rows may change from tick to tick.
  void split_bounds() {
    source_row_.clear();
    bound_sign_.clear();
    for (int i = 0; i < setup_.n_in; ++i) {
      if (std::isfinite(l_[i])) add_bound(i, -1.0);
      if (std::isfinite(u_[i])) add_bound(i, 1.0);
    }
    const auto rows = static_cast<Eigen::Index>(source_row_.size());
    CI_.resize(rows, setup_.n);
    ci_.resize(rows);
    for (Eigen::Index k = 0; k < rows; ++k) {
      const int i = source_row_[k];
      CI_.row(k) = -bound_sign_[k] * C_.row(i);
      ci_[k] = bound_sign_[k] > 0.0 ? u_[i] : -l_[i];
    }
    if (rows != allocated_rows_) solver_.reset(setup_.n, setup_.n_eq, allocated_rows_ = rows);
  }
  void add_bound(int row, double sign) {
    source_row_.push_back(row);
    bound_sign_.push_back(sign);
  }

  Setup setup_;
  ei::EiquadprogFast solver_;
  ei::EiquadprogFast_status status_{};
  Eigen::MatrixXd H_, A_, C_, CI_;
  Eigen::VectorXd g_, b_, l_, u_, ci_, minus_b_, x_;
  std::vector<int> source_row_;
  std::vector<double> bound_sign_;
  Eigen::Index allocated_rows_ = -1;
};

}  // namespace

std::unique_ptr<Adapter> make_adapter(const Setup& setup) {
  return std::make_unique<Eiquadprog>(setup);
}

}  // namespace bench
