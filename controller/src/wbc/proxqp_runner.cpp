// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/proxqp_runner.hpp"

// clang-format off: this one must come before the solver
#include "wbc/proxqp_no_malloc.hpp"
#include <proxsuite/proxqp/dense/dense.hpp>
// clang-format on

namespace surefoot {

namespace {

namespace proxqp = proxsuite::proxqp;

// Duality gap at which ProxQP stops, as a share of the tolerance. Chosen smaller than 1: ProxQP
// judges the sum of the gaps of all rows, QpCheck judges each row.
constexpr double kGapShare = 0.1;
// Multipliers smaller than this are rounding residues. Chosen larger than the residues seen, 1e-24,
// and smaller than the tolerance.
constexpr double kResidue = 1e-12;
// Largest number of outer iterations in an attempt, and of inner iterations in an outer iteration.
// Chosen: ProxQP has no time limit, so 12 x 8 = 96 inner iterations bound the time of an attempt.
// If an attempt needs more, QpSolver corrects the multipliers and starts another attempt.
constexpr int kMaxOuter = 12;
constexpr int kMaxInner = 8;

}  // namespace

struct ProxqpRunner::Workspace {
  Workspace(int n, int n_eq, int n_in)
      : qp(n, n_eq, n_in, false, proxqp::DenseBackend::PrimalDualLDLT) {}
  proxqp::dense::QP<double> qp;
};

ProxqpRunner::ProxqpRunner(int n, int n_eq, int n_in)
    : workspace_(std::make_unique<Workspace>(n, n_eq, n_in)) {
  auto& qp = workspace_->qp;
  qp.settings.eps_rel = 0.0;
  qp.settings.max_iter = kMaxOuter;
  qp.settings.max_iter_in = kMaxInner;
  // With the default of 1e-4, ProxQP 0.8.0 reports feasible balance QPs as infeasible after a warm
  // start. With 1e-9 or less it reported none of 3000 such QPs as infeasible.
  qp.settings.eps_primal_inf = 1e-12;
  qp.settings.eps_dual_inf = 1e-12;
  // With primal and dual residuals alone, ProxQP may stop with nonzero multipliers on inactive
  // rows. Such a result looks converged but is not optimal. The duality gap reveals it.
  qp.settings.check_duality_gap = true;
  qp.settings.eps_duality_gap_rel = 0.0;
  // Chosen: ProxQP solves these QPs with any value from 1e-3 to 1e-1; its default is 1e-1.
  qp.settings.default_mu_in = 1e-2;
  qp.settings.initial_guess = proxqp::InitialGuessStatus::WARM_START_WITH_PREVIOUS_RESULT;
  // init() is called once, to set the sizes and the identity preconditioner.
  const QpProblem dummy(n, n_eq, n_in);
  const RowMatrix identity = RowMatrix::Identity(n, n);
  qp.init(identity, dummy.g, dummy.A, dummy.b, dummy.C, dummy.l, dummy.u, false);
}

ProxqpRunner::~ProxqpRunner() = default;

Eigen::VectorXd& ProxqpRunner::x() noexcept { return workspace_->qp.results.x; }
Eigen::VectorXd& ProxqpRunner::y() noexcept { return workspace_->qp.results.y; }
Eigen::VectorXd& ProxqpRunner::z() noexcept { return workspace_->qp.results.z; }

void ProxqpRunner::set_tolerance(double tolerance) noexcept {
  workspace_->qp.settings.eps_abs = tolerance;
  workspace_->qp.settings.eps_duality_gap_abs = kGapShare * tolerance;
}

void ProxqpRunner::set_problem(const QpProblem& problem) noexcept {
  auto& model = workspace_->qp.model;
  model.H = problem.H;
  model.g = problem.g;
  model.A = problem.A;
  model.b = problem.b;
  model.C = problem.C;
  model.l = problem.l.cwiseMax(-kNoBound);
  model.u = problem.u.cwiseMin(kNoBound);
}

// QP::update() allocates memory and rescales. The QP is already scaled and has a fixed size. So
// run() copies the QP to the fields that update() would fill, requests a factorisation, and calls
// the solver directly.
ProxqpRunner::Outcome ProxqpRunner::run() noexcept {
  auto& qp = workspace_->qp;
  auto& work = qp.work;
  work.cleanup(false);
  work.H_scaled = qp.model.H;
  work.g_scaled = qp.model.g;
  work.A_scaled = qp.model.A;
  work.b_scaled = qp.model.b;
  work.C_scaled = qp.model.C;
  work.l_scaled = qp.model.l;
  work.u_scaled = qp.model.u;
  work.dual_feasibility_rhs_2 = qp.model.g.lpNorm<Eigen::Infinity>();
  work.correction_guess_rhs_g = work.dual_feasibility_rhs_2;
  work.is_initialized = true;
  work.refactorize = true;
  auto& info = qp.results.info;
  info.rho = qp.settings.default_rho;
  info.mu_eq = qp.settings.default_mu_eq;
  info.mu_eq_inv = 1.0 / info.mu_eq;
  info.mu_in = qp.settings.default_mu_in;
  info.mu_in_inv = 1.0 / info.mu_in;
  qp.results.cleanup_statistics();
  proxqp::dense::qp_solve(qp.settings, qp.model, qp.results, work, false, qp.which_dense_backend(),
                          qp.which_hessian_type(), qp.ruiz);
  // ProxQP leaves rounding residues of 1e-24 on nearly all multipliers. A warm start would treat
  // each row with a nonzero multiplier as active.
  auto& z = qp.results.z;
  z = (z.array().abs() < kResidue).select(0.0, z);
  Outcome outcome;
  outcome.iterations = static_cast<int>(info.iter);
  outcome.infeasible = info.status == proxqp::QPSolverOutput::PROXQP_PRIMAL_INFEASIBLE ||
                       info.status == proxqp::QPSolverOutput::PROXQP_DUAL_INFEASIBLE;
  return outcome;
}

}  // namespace surefoot
