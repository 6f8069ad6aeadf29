// SPDX-License-Identifier: BSD-3-Clause
// PIQP through its dense C++ interface: proximal interior-point method. PIQP is header-only, so it
// is compiled with the same Eigen and flags as the adapters.
#include <piqp/piqp.hpp>

#include "adapter.hpp"

namespace bench {

namespace {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

class Piqp : public Adapter {
 public:
  explicit Piqp(const Setup& s) : setup_(s) {
    auto& settings = solver_.settings();
    settings.eps_abs = s.tolerance;
    settings.eps_rel = 0.0;
    settings.eps_duality_gap_abs = s.tolerance;
    settings.eps_duality_gap_rel = 0.0;
    settings.preconditioner_reuse_on_update = s.warm;
  }

  Description describe() const override {
    return {"piqp", "c++", PEER_VERSION,
            "dense; eps_abs and eps_duality_gap_abs as requested, eps_rel 0, all else default; "
            "update() of all data, then solve()",
            "no warm start of the solution: PIQP has none; memory and preconditioner are kept"};
  }
  void clear_warm_start() override {}
  void load_problem(const Problem& p) override {
    P_ = Eigen::Map<const RowMatrix>(p.H, p.n, p.n);
    A_ = Eigen::Map<const RowMatrix>(p.A, p.n_eq, p.n);
    G_ = Eigen::Map<const RowMatrix>(p.C, p.n_in, p.n);
    c_ = Eigen::Map<const Eigen::VectorXd>(p.g, p.n);
    b_ = Eigen::Map<const Eigen::VectorXd>(p.b, p.n_eq);
    l_ = Eigen::Map<const Eigen::VectorXd>(p.l, p.n_in);
    u_ = Eigen::Map<const Eigen::VectorXd>(p.u, p.n_in);
  }
  SolveStatus solve() override {
    if (started_) {
      solver_.update(P_, c_, A_, b_, G_, l_, u_);
    } else {
      solver_.setup(P_, c_, A_, b_, G_, l_, u_);
      started_ = true;
    }
    return solver_.solve() == piqp::Status::PIQP_SOLVED ? SolveStatus::kSolved
                                                        : SolveStatus::kFailed;
  }
  int iterations() const override { return static_cast<int>(solver_.result().info.iter); }
  void read_solution(Solution& a) const override {
    const auto& r = solver_.result();
    a.x.assign(r.x.begin(), r.x.end());
    a.y.assign(r.y.begin(), r.y.end());
    for (int i = 0; i < setup_.n_in; ++i) a.z[i] = r.z_u[i] - r.z_l[i];
  }

 private:
  Setup setup_;
  piqp::DenseSolver<double> solver_;
  Eigen::MatrixXd P_, A_, G_;
  Eigen::VectorXd c_, b_, l_, u_;
  bool started_ = false;
};

}  // namespace

std::unique_ptr<Adapter> make_adapter(const Setup& setup) { return std::make_unique<Piqp>(setup); }

}  // namespace bench
