// SPDX-License-Identifier: BSD-3-Clause
// ProxQP through QP::update() and QP::solve(), as in its documentation.
#include <proxsuite/proxqp/dense/dense.hpp>

#include "adapter.hpp"

namespace bench {

namespace {

namespace proxqp = proxsuite::proxqp;
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

class Proxqp : public Adapter {
 public:
  explicit Proxqp(const Setup& s) : setup_(s) { make(); }

  Description describe() const override {
    return {
        "proxqp", "c++", PEER_VERSION,
        "dense QP, update(update_preconditioner = false) and solve(); eps_abs as requested, "
        "eps_rel 0, eps_primal_inf and eps_dual_inf 1e-12, check_duality_gap with eps 0.1 times "
        "the requested one, all else default",
        "initial_guess WARM_START_WITH_PREVIOUS_RESULT"};
  }
  void clear_warm_start() override {
    if (!setup_.warm) qp_->settings.initial_guess = proxqp::InitialGuessStatus::NO_INITIAL_GUESS;
  }
  void load_problem(const Problem& p) override {
    H_ = Eigen::Map<const RowMatrix>(p.H, p.n, p.n);
    A_ = Eigen::Map<const RowMatrix>(p.A, p.n_eq, p.n);
    C_ = Eigen::Map<const RowMatrix>(p.C, p.n_in, p.n);
    g_ = Eigen::Map<const Eigen::VectorXd>(p.g, p.n);
    b_ = Eigen::Map<const Eigen::VectorXd>(p.b, p.n_eq);
    l_ = Eigen::Map<const Eigen::VectorXd>(p.l, p.n_in).cwiseMax(-1e20);
    u_ = Eigen::Map<const Eigen::VectorXd>(p.u, p.n_in).cwiseMin(1e20);
  }
  SolveStatus solve() override {
    if (started_) {
      qp_->update(H_, g_, A_, b_, C_, l_, u_, false);
    } else {
      qp_->init(H_, g_, A_, b_, C_, l_, u_, true);
      started_ = true;
    }
    qp_->solve();
    const auto status = qp_->results.info.status;
    return status == proxqp::QPSolverOutput::PROXQP_SOLVED ? SolveStatus::kSolved
                                                           : SolveStatus::kFailed;
  }
  int iterations() const override { return static_cast<int>(qp_->results.info.iter); }
  void read_solution(Solution& a) const override {
    a.x.assign(qp_->results.x.begin(), qp_->results.x.end());
    a.y.assign(qp_->results.y.begin(), qp_->results.y.end());
    a.z.assign(qp_->results.z.begin(), qp_->results.z.end());
  }

 private:
  void make() {
    qp_ = std::make_unique<proxqp::dense::QP<double>>(setup_.n, setup_.n_eq, setup_.n_in);
    qp_->settings.eps_abs = setup_.tolerance;
    qp_->settings.eps_rel = 0.0;
    qp_->settings.eps_primal_inf = qp_->settings.eps_dual_inf = 1e-12;
    qp_->settings.check_duality_gap = true;
    qp_->settings.eps_duality_gap_abs = 0.1 * setup_.tolerance;
    qp_->settings.eps_duality_gap_rel = 0.0;
    qp_->settings.initial_guess = proxqp::InitialGuessStatus::WARM_START_WITH_PREVIOUS_RESULT;
  }

  Setup setup_;
  std::unique_ptr<proxqp::dense::QP<double>> qp_;
  RowMatrix H_, A_, C_;
  Eigen::VectorXd g_, b_, l_, u_;
  bool started_ = false;
};

}  // namespace

std::unique_ptr<Adapter> make_adapter(const Setup& setup) {
  return std::make_unique<Proxqp>(setup);
}

}  // namespace bench
