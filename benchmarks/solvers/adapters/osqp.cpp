// SPDX-License-Identifier: BSD-3-Clause
// OSQP through its C interface: ADMM on sparse data. The sparsity pattern is fixed beforehand. The
// copy of each tick's values into the columns is timed.
#include <osqp/osqp.h>

#include <algorithm>
#include <cmath>

#include "adapter.hpp"

namespace bench {

namespace {

/// Compressed sparse columns of a dense row-major matrix with a known pattern.
struct Columns {
  std::vector<OSQPInt> start{0}, row;
  std::vector<int> source_index;  // index in the dense data
  std::vector<double> value;

  void add(int dense_index, int at_row) {
    source_index.push_back(dense_index);
    row.push_back(at_row);
  }
  void end_column() { start.push_back(static_cast<OSQPInt>(row.size())); }
  void gather(const double* dense) {
    for (std::size_t k = 0; k < source_index.size(); ++k) value[k] = dense[source_index[k]];
  }
};

class Osqp : public Adapter {
 public:
  explicit Osqp(const Setup& s) : setup_(s), rows_(s.n_eq + s.n_in) {
    for (int j = 0; j < s.n; ++j) {
      for (int i = 0; i <= j; ++i) {
        if (used(s.H_pattern, i * s.n + j)) P_.add(i * s.n + j, i);
      }
      P_.end_column();
      for (int i = 0; i < rows_; ++i) {
        const bool equality = i < s.n_eq;
        const int k = (equality ? i : i - s.n_eq) * s.n + j;
        if (used(equality ? s.A_pattern : s.C_pattern, k)) A_.add(i * s.n + j, i);
      }
      A_.end_column();
    }
    P_.value.resize(P_.source_index.size());
    A_.value.resize(A_.source_index.size());
    dense_H_.resize(s.n * s.n);
    dense_A_.resize(rows_ * s.n);
    q_.resize(s.n);
    lower_.resize(rows_);
    upper_.resize(rows_);
    osqp_set_default_settings(&settings_);
    settings_.verbose = 0;
    settings_.eps_abs = kToleranceFactor * s.tolerance;
    settings_.eps_rel = 0.0;
    settings_.max_iter = 20000;
    settings_.eps_prim_inf = settings_.eps_dual_inf = 1e-10;
    settings_.adaptive_rho_interval = 25;
    settings_.check_termination = 10;
    settings_.warm_starting = 1;
  }
  ~Osqp() override { osqp_cleanup(solver_); }

  Description describe() const override {
    return {"osqp", "c", osqp_version(),
            "sparse, pattern known beforehand; eps_abs 0.1 times the requested one, eps_rel 0, "
            "no polishing, max_iter 20000, adaptive_rho_interval 25, check_termination 10",
            "primal and dual variables and rho of the last tick"};
  }
  void clear_warm_start() override {
    if (solver_ == nullptr) return;
    osqp_cold_start(solver_);
    osqp_update_rho(solver_, settings_.rho);
  }
  void load_problem(const Problem& p) override {
    std::copy_n(p.H, p.n * p.n, dense_H_.begin());
    std::copy_n(p.A, p.n_eq * p.n, dense_A_.begin());
    std::copy_n(p.C, p.n_in * p.n, dense_A_.begin() + p.n_eq * p.n);
    std::copy_n(p.g, p.n, q_.begin());
    std::copy_n(p.b, p.n_eq, lower_.begin());
    std::copy_n(p.b, p.n_eq, upper_.begin());
    const auto bound = [](double v) { return std::clamp(v, -OSQP_INFTY, OSQP_INFTY); };
    std::transform(p.l, p.l + p.n_in, lower_.begin() + p.n_eq, bound);
    std::transform(p.u, p.u + p.n_in, upper_.begin() + p.n_eq, bound);
  }
  SolveStatus solve() override {
    P_.gather(dense_H_.data());
    A_.gather(dense_A_.data());
    if (solver_ == nullptr) {
      if (!start()) return SolveStatus::kFailed;
    } else {
      osqp_update_data_vec(solver_, q_.data(), lower_.data(), upper_.data());
      if (osqp_update_data_mat(solver_, P_.value.data(), nullptr, 0, A_.value.data(), nullptr, 0)) {
        return SolveStatus::kFailed;
      }
    }
    osqp_solve(solver_);
    return solver_->info->status_val == OSQP_SOLVED ? SolveStatus::kSolved : SolveStatus::kFailed;
  }
  int iterations() const override {
    return solver_ == nullptr ? 0 : static_cast<int>(solver_->info->iter);
  }
  void read_solution(Solution& a) const override {
    if (solver_ == nullptr) return;
    const OSQPSolution& s = *solver_->solution;
    std::copy_n(s.x, setup_.n, a.x.begin());
    std::copy_n(s.y, setup_.n_eq, a.y.begin());
    std::copy_n(s.y + setup_.n_eq, setup_.n_in, a.z.begin());
  }

 private:
  // Ratio of eps_abs to the requested tolerance. OSQP checks the residuals of its scaled QP. With
  // the ratio 1, some answers would exceed the tolerance in the residuals of the original QP.
  static constexpr double kToleranceFactor = 0.1;

  static bool used(const std::vector<char>& pattern, int k) {
    return pattern.empty() || pattern[k] != 0;
  }
  bool start() {
    const OSQPInt n = setup_.n, m = rows_;
    OSQPCscMatrix P{}, A{};
    OSQPCscMatrix_set_data(&P, n, n, OSQPInt(P_.row.size()), P_.value.data(), P_.row.data(),
                           P_.start.data());
    OSQPCscMatrix_set_data(&A, m, n, OSQPInt(A_.row.size()), A_.value.data(), A_.row.data(),
                           A_.start.data());
    return osqp_setup(&solver_, &P, q_.data(), &A, lower_.data(), upper_.data(), m, n,
                      &settings_) == 0;
  }

  Setup setup_;
  int rows_;
  Columns P_, A_;
  std::vector<double> dense_H_, dense_A_, q_, lower_, upper_;
  OSQPSettings settings_{};
  OSQPSolver* solver_ = nullptr;
};

}  // namespace

std::unique_ptr<Adapter> make_adapter(const Setup& setup) { return std::make_unique<Osqp>(setup); }

}  // namespace bench
