// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/qp_solver.hpp"

// clang-format off: this one must come before the solver
#include "wbc/proxqp_no_malloc.hpp"
#include <proxsuite/proxqp/dense/dense.hpp>
// clang-format on

#include <cmath>

#include "wbc/active_set_steps.hpp"
#include "wbc/qp_check.hpp"

namespace surefoot {

namespace {

namespace proxqp = proxsuite::proxqp;

constexpr double kSolverGap = 0.1;  // times the tolerance
constexpr double kResidue = 1e-12;
constexpr int kSteps = 80;        // of the active set method, before ProxQP is asked
constexpr int kWarmAttempts = 3;  // warm, then from the corrected multipliers; after that from
constexpr int kAttempts = 6;      // nothing, and on from there
constexpr double kTight = 1e-8;   // below this tolerance time is no object: offline checks
constexpr int kTightFactor = 10;
constexpr int kMaxOuter = 12;
constexpr int kMaxInner = 8;

}  // namespace

struct QpSolver::Workspace {
  Workspace(int n, int n_eq, int n_in)
      : qp(n, n_eq, n_in, false, proxqp::DenseBackend::PrimalDualLDLT),
        steps(n, n_eq, n_in),
        check(n, n_eq, n_in) {}
  proxqp::dense::QP<double> qp;
  ActiveSetSteps steps;
  QpCheck check;
};

QpSolver::QpSolver(int n, int n_eq, int n_in, double tolerance)
    : workspace_(std::make_unique<Workspace>(n, n_eq, n_in)),
      patience_(tolerance < kTight ? kTightFactor : 1) {
  auto& qp = workspace_->qp;
  set_tolerance(tolerance);
  qp.settings.eps_rel = 0.0;
  qp.settings.max_iter = kMaxOuter;
  qp.settings.max_iter_in = kMaxInner;
  // With the default 1e-4 a warm start makes feasible balance programs "infeasible".
  qp.settings.eps_primal_inf = 1e-12;
  qp.settings.eps_dual_inf = 1e-12;
  // Primal and dual residuals alone let it stop with multipliers on rows that are not active:
  // forces that look converged and are not optimal. The gap is what tells.
  qp.settings.check_duality_gap = true;
  qp.settings.eps_duality_gap_rel = 0.0;
  qp.settings.default_mu_in = 1e-2;
  qp.settings.initial_guess = proxqp::InitialGuessStatus::WARM_START_WITH_PREVIOUS_RESULT;
  // Once through the front door for sizes and the identity preconditioner.
  const QpProblem dummy(n, n_eq, n_in);
  const RowMatrix identity = RowMatrix::Identity(n, n);
  qp.init(identity, dummy.g, dummy.A, dummy.b, dummy.C, dummy.l, dummy.u, false);
}

QpSolver::~QpSolver() = default;

void QpSolver::reset() noexcept { has_answer_ = false; }

const Eigen::VectorXd& QpSolver::x() const noexcept { return workspace_->qp.results.x; }
const Eigen::VectorXd& QpSolver::z() const noexcept { return workspace_->qp.results.z; }

const Eigen::VectorXd& QpSolver::y() const noexcept { return workspace_->qp.results.y; }

void QpSolver::set_tolerance(double tolerance) noexcept {
  tolerance_ = tolerance;
  workspace_->qp.settings.eps_abs = tolerance;
  workspace_->qp.settings.eps_duality_gap_abs = kSolverGap * tolerance;
}

QpResult QpSolver::solve(const QpProblem& problem, int budget) noexcept {
  QpResult result;
  if (!QpCheck::finite(problem)) {
    result.status = Status::kNonFinite;
    return result;
  }
  if (!has_answer_) forget();
  result = try_steps(problem);
  if (result.status != Status::kOk) {
    const int steps = result.iterations;
    result = run_proxqp(problem, budget);
    result.iterations += steps;
  }
  has_answer_ = result.status == Status::kOk;
  return result;
}

// Most ticks end here: the rows on their bounds are those of the last tick, or nearly. What comes
// out is accepted by the same check as all else, and what does not pass it leaves no trace.
QpResult QpSolver::try_steps(const QpProblem& problem) noexcept {
  auto& [qp, steps, check] = *workspace_;
  QpResult result;
  bool going = steps.start(problem, qp.results.z);
  int count = 0;
  while (going && count < kSteps && steps.step(problem)) {
    ++count;
    result = check(problem, steps.x(), steps.y(), steps.z(), tolerance_);
    if (result.status == Status::kOk) {
      qp.results.x = steps.x();
      qp.results.y = steps.y();
      qp.results.z = steps.z();
      break;
    }
    going = steps.enter(problem, check.Cx(), tolerance_);
  }
  result.iterations = count;
  return result;
}

QpResult QpSolver::run_proxqp(const QpProblem& problem, int budget) noexcept {
  QpResult result;
  int spent = 0;
  write(problem);
  // A warm start counts every multiplier that is not exactly zero as an active row. The last solve
  // leaves rounding residues of 1e-24 on nearly all of them, and inserting those costs 15 us.
  auto& z = workspace_->qp.results.z;
  z = (z.array().abs() < kResidue).select(0.0, z);
  for (int attempt = 0; attempt < patience_ * kAttempts; ++attempt) {
    if (attempt % kAttempts == kWarmAttempts || !x().allFinite()) forget();
    result = run(problem);
    spent += result.iterations;
    if (result.status == Status::kOk || spent >= patience_ * budget) break;
    drop_slack_multipliers(problem);
  }
  result.iterations = spent;
  return result;
}

void QpSolver::forget() noexcept {
  workspace_->qp.results.x.setZero();
  workspace_->qp.results.y.setZero();
  workspace_->qp.results.z.setZero();
}

// Multipliers on rows away from their bound, or of the wrong sign, mark an answer that is not yet
// optimal; without them the next run starts where this one should have gone on.
void QpSolver::drop_slack_multipliers(const QpProblem& problem) noexcept {
  auto& z = workspace_->qp.results.z;
  const auto& Cx = workspace_->check.Cx();
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    if (!(QpCheck::row_gap(z[i], Cx[i], problem.l[i], problem.u[i]) <= tolerance_)) z[i] = 0.0;
  }
}

void QpSolver::write(const QpProblem& problem) noexcept {
  auto& model = workspace_->qp.model;
  model.H = problem.H;
  model.g = problem.g;
  model.A = problem.A;
  model.b = problem.b;
  model.C = problem.C;
  model.l = problem.l.cwiseMax(-kNoBound);
  model.u = problem.u.cwiseMin(kNoBound);
}

// QP::update() allocates and rescales; the problem is scaled and of fixed size, so put it where
// update() would have put it, refactorise, and go straight to the solve.
QpResult QpSolver::run(const QpProblem& problem) noexcept {
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
  work.dual_feasibility_rhs_2 = problem.g.lpNorm<Eigen::Infinity>();
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
  QpResult result =
      workspace_->check(problem, qp.results.x, qp.results.y, qp.results.z, tolerance_);
  result.iterations = static_cast<int>(qp.results.info.iter);
  const bool infeasible =
      qp.results.info.status == proxqp::QPSolverOutput::PROXQP_PRIMAL_INFEASIBLE ||
      qp.results.info.status == proxqp::QPSolverOutput::PROXQP_DUAL_INFEASIBLE;
  if (infeasible && result.status != Status::kOk) result.status = Status::kInfeasible;
  return result;
}

}  // namespace surefoot
