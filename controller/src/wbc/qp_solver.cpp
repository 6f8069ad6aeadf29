// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/qp_solver.hpp"

// clang-format off: this one must come before the solver
#include "wbc/proxqp_no_malloc.hpp"
#include "surefoot/stage_clock.hpp"
#include "wbc/active_set.hpp"
#include "wbc/qp_check.hpp"
#include <proxsuite/proxqp/dense/dense.hpp>
// clang-format on

#include <cmath>

namespace surefoot {

namespace {

namespace proxqp = proxsuite::proxqp;

constexpr double kSolverGap = 0.1;  // times the tolerance
constexpr double kResidue = 1e-12;
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
        check(n, n_eq, n_in),
        active_set(n, n_eq, n_in) {}
  proxqp::dense::QP<double> qp;
  QpCheck check;
  ActiveSet active_set;
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

void QpSolver::start_from(const Eigen::VectorXd& z) noexcept {
  forget();
  workspace_->qp.results.z = z;
  has_answer_ = true;
}

const Eigen::VectorXd& QpSolver::x() const noexcept { return workspace_->qp.results.x; }
const Eigen::VectorXd& QpSolver::z() const noexcept { return workspace_->qp.results.z; }

const Eigen::VectorXd& QpSolver::y() const noexcept { return workspace_->qp.results.y; }

void QpSolver::set_tolerance(double tolerance) noexcept {
  tolerance_ = tolerance;
  workspace_->qp.settings.eps_abs = tolerance;
  workspace_->qp.settings.eps_duality_gap_abs = kSolverGap * tolerance;
}

QpResult QpSolver::solve(const QpProblem& problem, int budget, Feasibility feasibility) noexcept {
  const StageScope stage(Stage::kSolve);
  QpResult result;
  if (!has_answer_) forget();
  result = try_active_set(problem);
  if (result.status == Status::kOk) return result;
  if (!QpCheck::finite(problem)) {
    result.status = Status::kNonFinite;
    return result;
  }
  if (result.status == Status::kInfeasible && feasibility == Feasibility::kDoubtful) return result;
  write(problem);
  // A warm start counts every multiplier that is not exactly zero as an active row. The last solve
  // leaves rounding residues of 1e-24 on nearly all of them, and inserting those costs 15 us.
  auto& z = workspace_->qp.results.z;
  z = (z.array().abs() < kResidue).select(0.0, z);
  int spent = result.iterations;
  for (int attempt = 0; attempt < patience_ * kAttempts; ++attempt) {
    if (attempt % kAttempts == kWarmAttempts || !x().allFinite()) forget();
    result = run(problem);
    spent += result.iterations;
    if (result.status == Status::kOk || spent >= patience_ * budget) break;
    drop_slack_multipliers(problem);
  }
  result.iterations = spent;
  has_answer_ = result.status == Status::kOk;
  return result;
}

// The rows that were active last, first: mostly they are it, or nearly.
QpResult QpSolver::try_active_set(const QpProblem& problem) noexcept {
  auto& results = workspace_->qp.results;
  ActiveSet& active_set = workspace_->active_set;
  const auto outcome = active_set.solve(problem, tolerance_, results.x, results.y, results.z);
  QpResult result;
  if (outcome == ActiveSet::Outcome::kSolved) result = check(problem);
  if (outcome == ActiveSet::Outcome::kInfeasible) result.status = Status::kInfeasible;
  result.iterations = active_set.iterations();
  has_answer_ = result.status == Status::kOk;
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
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    const double gap =
        QpCheck::row_gap(z[i], workspace_->check.Cx()[i], problem.l[i], problem.u[i]);
    if (!(gap <= tolerance_)) z[i] = 0.0;
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
  QpResult result = check(problem);
  result.iterations = static_cast<int>(info.iter);
  const bool infeasible = info.status == proxqp::QPSolverOutput::PROXQP_PRIMAL_INFEASIBLE ||
                          info.status == proxqp::QPSolverOutput::PROXQP_DUAL_INFEASIBLE;
  if (infeasible && result.status != Status::kOk) result.status = Status::kInfeasible;
  return result;
}

QpResult QpSolver::check(const QpProblem& problem) noexcept {
  const StageScope stage(Stage::kCheck);
  const auto& results = workspace_->qp.results;
  return workspace_->check(problem, results.x, results.y, results.z, tolerance_);
}

}  // namespace surefoot
