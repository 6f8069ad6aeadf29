// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/qp_solver.hpp"

#include <cmath>
#include <proxsuite/proxqp/dense/dense.hpp>

namespace surefoot {

namespace {

namespace proxqp = proxsuite::proxqp;

constexpr double kSolverTolerance = 1e-6;
constexpr double kSolverGap = 1e-7;
constexpr double kAcceptTolerance = 5e-6;  // ours; the same residuals, computed by us
constexpr double kAcceptGap = 1e-6;
constexpr double kInfinity = 1e20;  // ProxQP's word for "no bound"
constexpr int kMaxOuter = 12;
constexpr int kMaxInner = 8;

bool finite(const QpProblem& p) {
  // NaN in l or u would silently drop that bound inside ProxQP; infinities are allowed there.
  return p.H.allFinite() && p.g.allFinite() && p.C.allFinite() && !p.l.hasNaN() && !p.u.hasNaN();
}

}  // namespace

struct QpSolver::Workspace {
  Workspace(int n, int n_in)
      : qp(n, 0, n_in, false, proxqp::DenseBackend::PrimalDualLDLT),
        Cx(n_in),
        gradient(n) {}
  proxqp::dense::QP<double> qp;
  Eigen::VectorXd Cx, gradient;
};

QpSolver::QpSolver(int n, int n_in) : workspace_(std::make_unique<Workspace>(n, n_in)) {
  auto& qp = workspace_->qp;
  qp.settings.eps_abs = kSolverTolerance;
  qp.settings.eps_rel = 0.0;
  qp.settings.max_iter = kMaxOuter;
  qp.settings.max_iter_in = kMaxInner;
  // With the default 1e-4 a warm start makes feasible balance programs "infeasible".
  qp.settings.eps_primal_inf = 1e-12;
  qp.settings.eps_dual_inf = 1e-12;
  // Primal and dual residuals alone let it stop with multipliers on rows that are not active: forces
  // that look converged and are not optimal. The gap is what tells.
  qp.settings.check_duality_gap = true;
  qp.settings.eps_duality_gap_abs = kSolverGap;
  qp.settings.eps_duality_gap_rel = 0.0;
  qp.settings.default_mu_in = 1e-3;
  qp.settings.initial_guess = proxqp::InitialGuessStatus::WARM_START_WITH_PREVIOUS_RESULT;
  // Once through the front door for sizes and the identity preconditioner.
  const QpProblem dummy(n, n_in);
  const RowMatrix identity = RowMatrix::Identity(n, n);
  qp.init(identity, dummy.g, proxsuite::nullopt, proxsuite::nullopt, dummy.C, dummy.l, dummy.u, false);
}

QpSolver::~QpSolver() = default;

void QpSolver::reset() noexcept { has_answer_ = false; }

const Eigen::VectorXd& QpSolver::x() const noexcept { return workspace_->qp.results.x; }
const Eigen::VectorXd& QpSolver::z() const noexcept { return workspace_->qp.results.z; }

QpResult QpSolver::solve(const QpProblem& problem) noexcept {
  QpResult result;
  if (!finite(problem)) {
    result.status = Status::kNonFinite;
    return result;
  }
  result = attempt(problem, has_answer_);
  if (result.status != Status::kOk && has_answer_) {
    const int spent = result.iterations;
    result = attempt(problem, false);
    result.iterations += spent;
  }
  has_answer_ = result.status == Status::kOk;
  return result;
}

// QP::update() allocates and rescales; the problem is scaled and of fixed size, so write it where
// update() would have put it, refactorise, and go straight to the solve.
QpResult QpSolver::attempt(const QpProblem& problem, bool warm) noexcept {
  auto& [qp, Cx, gradient] = *workspace_;
  auto& results = qp.results;
  if (!warm) {
    results.x.setZero();
    results.z.setZero();
  }
  qp.work.cleanup(false);
  qp.model.H = problem.H;
  qp.model.g = problem.g;
  qp.model.C = problem.C;
  qp.model.l = problem.l.cwiseMax(-kInfinity);
  qp.model.u = problem.u.cwiseMin(kInfinity);
  qp.work.H_scaled = qp.model.H;
  qp.work.g_scaled = qp.model.g;
  qp.work.C_scaled = qp.model.C;
  qp.work.l_scaled = qp.model.l;
  qp.work.u_scaled = qp.model.u;
  qp.work.dual_feasibility_rhs_2 = problem.g.lpNorm<Eigen::Infinity>();
  qp.work.correction_guess_rhs_g = qp.work.dual_feasibility_rhs_2;
  qp.work.is_initialized = true;
  qp.work.refactorize = true;
  results.info.rho = qp.settings.default_rho;
  results.info.mu_in = qp.settings.default_mu_in;
  results.info.mu_in_inv = 1.0 / results.info.mu_in;
  results.cleanup_statistics();

  proxqp::dense::qp_solve(qp.settings, qp.model, results, qp.work, false, qp.which_dense_backend(),
                          qp.which_hessian_type(), qp.ruiz);

  QpResult out;
  out.iterations = static_cast<int>(results.info.iter);
  Cx.noalias() = problem.C * results.x;
  gradient = problem.g;
  gradient.noalias() += problem.H * results.x;
  gradient.noalias() += problem.C.transpose() * results.z;
  out.primal_residual =
      std::max({0.0, (problem.l - Cx).maxCoeff(), (Cx - problem.u).maxCoeff()});
  out.dual_residual = gradient.lpNorm<Eigen::Infinity>();
  for (Eigen::Index i = 0; i < Cx.size(); ++i) {
    const double bound = results.z[i] > 0.0 ? qp.model.u[i] : qp.model.l[i];
    // A multiplier on a side that has no bound is wrong by its whole size.
    const double distance = std::abs(bound) < kInfinity ? std::abs(bound - Cx[i]) : 1.0;
    out.gap = std::max(out.gap, std::abs(results.z[i]) * distance);
  }
  const bool accepted = results.x.allFinite() && results.z.allFinite() &&
                        out.primal_residual <= kAcceptTolerance &&
                        out.dual_residual <= kAcceptTolerance && out.gap <= kAcceptGap;
  const bool infeasible = results.info.status == proxqp::QPSolverOutput::PROXQP_PRIMAL_INFEASIBLE ||
                          results.info.status == proxqp::QPSolverOutput::PROXQP_DUAL_INFEASIBLE;
  out.status = accepted ? Status::kOk : infeasible ? Status::kInfeasible : Status::kMaxIterations;
  return out;
}

}  // namespace surefoot
