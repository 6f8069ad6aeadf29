// SPDX-License-Identifier: BSD-3-Clause
// HPIPM through its dense C interface: interior-point method on BLASFEO.
#include <hpipm_d_dense_qp.h>
#include <hpipm_d_dense_qp_dim.h>
#include <hpipm_d_dense_qp_ipm.h>
#include <hpipm_d_dense_qp_sol.h>

#include <algorithm>
#include <cmath>

#include "adapter.hpp"

namespace bench {

namespace {

class Hpipm : public Adapter {
 public:
  explicit Hpipm(const Setup& s)
      : setup_(s), A_(s.n_eq * s.n), C_(s.n_in * s.n), H_(s.n * s.n), g_(s.n), b_(s.n_eq) {
    for (auto* rows : {&l_, &u_, &l_mask_, &u_mask_, &lower_multipliers_, &upper_multipliers_})
      rows->resize(s.n_in);
    dim_memory_.resize(d_dense_qp_dim_memsize());
    d_dense_qp_dim_create(&dim_, dim_memory_.data());
    d_dense_qp_dim_set_all(s.n, s.n_eq, 0, s.n_in, 0, &dim_);
    qp_memory_.resize(d_dense_qp_memsize(&dim_));
    d_dense_qp_create(&dim_, &qp_, qp_memory_.data());
    d_dense_qp_set_all_zero(&qp_);
    solution_memory_.resize(d_dense_qp_sol_memsize(&dim_));
    d_dense_qp_sol_create(&dim_, &solution_, solution_memory_.data());
    settings_memory_.resize(d_dense_qp_ipm_arg_memsize(&dim_));
    d_dense_qp_ipm_arg_create(&dim_, &settings_, settings_memory_.data());
    set_settings();
    work_memory_.resize(d_dense_qp_ipm_ws_memsize(&dim_, &settings_));
    d_dense_qp_ipm_ws_create(&dim_, &settings_, &work_, work_memory_.data());
  }

  Description describe() const override {
    return {"hpipm", "c", PEER_VERSION,
            "dense, BALANCE mode; tolerances of the four residuals as requested; iter_max 100",
            "hot start (warm_start 3: primal, dual and slacks of the last tick); cold start after "
            "a failure"};
  }
  void clear_warm_start() override { has_solution_ = false; }
  void load_problem(const Problem& p) override {
    std::copy_n(p.H, p.n * p.n, H_.begin());
    std::copy_n(p.g, p.n, g_.begin());
    std::copy_n(p.b, p.n_eq, b_.begin());
    for (int j = 0; j < p.n; ++j) {
      for (int i = 0; i < p.n_eq; ++i) A_[j * p.n_eq + i] = p.A[i * p.n + j];
      for (int i = 0; i < p.n_in; ++i) C_[j * p.n_in + i] = p.C[i * p.n + j];
    }
    for (int i = 0; i < p.n_in; ++i) {
      l_mask_[i] = std::isfinite(p.l[i]) ? 1.0 : 0.0;
      u_mask_[i] = std::isfinite(p.u[i]) ? 1.0 : 0.0;
      l_[i] = std::isfinite(p.l[i]) ? p.l[i] : 0.0;
      u_[i] = std::isfinite(p.u[i]) ? p.u[i] : 0.0;
    }
  }
  SolveStatus solve() override {
    d_dense_qp_set_H(H_.data(), &qp_);
    d_dense_qp_set_g(g_.data(), &qp_);
    if (setup_.n_eq > 0) {
      d_dense_qp_set_A(A_.data(), &qp_);
      d_dense_qp_set_b(b_.data(), &qp_);
    }
    d_dense_qp_set_C(C_.data(), &qp_);
    d_dense_qp_set_lg(l_.data(), &qp_);
    d_dense_qp_set_ug(u_.data(), &qp_);
    d_dense_qp_set_lg_mask(l_mask_.data(), &qp_);
    d_dense_qp_set_ug_mask(u_mask_.data(), &qp_);
    int warm_start = has_solution_ ? kHotStart : 0;
    d_dense_qp_ipm_arg_set_warm_start(&warm_start, &settings_);
    d_dense_qp_ipm_solve(&qp_, &solution_, &settings_, &work_);
    int status = 0;
    d_dense_qp_ipm_get_status(&work_, &status);
    has_solution_ = status == 0;
    return has_solution_ ? SolveStatus::kSolved : SolveStatus::kFailed;
  }
  int iterations() const override { return work_.iter; }
  void read_solution(Solution& a) const override {
    auto* solution = const_cast<d_dense_qp_sol*>(&solution_);
    d_dense_qp_sol_get_v(solution, a.x.data());
    if (setup_.n_eq > 0) d_dense_qp_sol_get_pi(solution, a.y.data());
    for (double& y : a.y) y = -y;  // HPIPM's Lagrangian has -pi'(A x - b)
    d_dense_qp_sol_get_lam_lg(solution, lower_multipliers_.data());
    d_dense_qp_sol_get_lam_ug(solution, upper_multipliers_.data());
    for (int i = 0; i < setup_.n_in; ++i) {
      a.z[i] = u_mask_[i] * upper_multipliers_[i] - l_mask_[i] * lower_multipliers_[i];
    }
  }

 private:
  static constexpr int kHotStart = 3;  // warm_start of HPIPM: primal, dual and slack variables

  void set_settings() {
    d_dense_qp_ipm_arg_set_default(BALANCE, &settings_);
    double tolerance = setup_.tolerance;
    int iterations = 100;
    d_dense_qp_ipm_arg_set_tol_stat(&tolerance, &settings_);
    d_dense_qp_ipm_arg_set_tol_eq(&tolerance, &settings_);
    d_dense_qp_ipm_arg_set_tol_ineq(&tolerance, &settings_);
    d_dense_qp_ipm_arg_set_tol_comp(&tolerance, &settings_);
    d_dense_qp_ipm_arg_set_iter_max(&iterations, &settings_);
  }

  Setup setup_;
  std::vector<double> A_, C_, H_, g_, b_;
  std::vector<double> l_, u_, l_mask_, u_mask_;
  mutable std::vector<double> lower_multipliers_,
      upper_multipliers_;  // buffers for read_solution()
  std::vector<char> dim_memory_, qp_memory_, solution_memory_, settings_memory_, work_memory_;
  d_dense_qp_dim dim_{};
  d_dense_qp qp_{};
  d_dense_qp_sol solution_{};
  d_dense_qp_ipm_arg settings_{};
  d_dense_qp_ipm_ws work_{};
  bool has_solution_ = false;
};

}  // namespace

std::unique_ptr<Adapter> make_adapter(const Setup& setup) { return std::make_unique<Hpipm>(setup); }

}  // namespace bench
