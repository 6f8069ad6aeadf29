// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "random_qp.hpp"
#include "wbc/active_set.hpp"

using namespace surefoot;

namespace {

using Outcome = ActiveSet::Outcome;

struct ActiveSetRun {
  explicit ActiveSetRun(const QpProblem& p, double tolerance = 1e-10)
      : method(int(p.g.size()), int(p.b.size()), int(p.l.size())), x(p.g), y(p.b), z(p.l) {
    z.setZero();
    outcome = method.solve(p, tolerance, x, y, z);
  }
  ActiveSet method;
  Eigen::VectorXd x, y, z;
  Outcome outcome;
};

double residual(const QpProblem& p, const ActiveSetRun& s) {
  return kkt_residual(p, s.x, s.y, s.z);
}

// Write the QP that minimises |x - target|^2 / 2; its rows have no bounds yet.
QpProblem projection_qp(const Eigen::VectorXd& target, int rows) {
  QpProblem p(int(target.size()), 0, rows);
  p.H.setIdentity();
  p.g = -target;
  p.l.setConstant(-kNoBound);
  p.u.setConstant(kNoBound);
  return p;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(active_set)

BOOST_AUTO_TEST_CASE(random_qps_are_solved_from_a_cold_start) {
  for (int seed = 0; seed < 500; ++seed) {
    const RandomQp random(seed);
    const ActiveSetRun s(random.problem);
    BOOST_REQUIRE((s.outcome == Outcome::kSolved));
    BOOST_TEST(residual(random.problem, s) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(warm_start_with_the_optimal_active_set_takes_one_iteration) {
  for (int seed = 0; seed < 50; ++seed) {
    const RandomQp random(seed);
    ActiveSetRun s(random.problem);
    const Eigen::VectorXd x = s.x;
    BOOST_TEST((s.method.solve(random.problem, 1e-10, s.x, s.y, s.z) == Outcome::kSolved));
    BOOST_TEST(s.method.iterations() == 1);
    BOOST_TEST((s.x - x).norm() < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(equality_constraints_hold_at_the_solution) {
  for (int seed = 0; seed < 100; ++seed) {
    const RandomQp random(seed, 30, 18, 88);
    const ActiveSetRun s(random.problem);
    BOOST_TEST((s.outcome == Outcome::kSolved));
    BOOST_TEST(residual(random.problem, s) < 1e-8);
  }
}

// The general form sets the equality rows of a soft foot to zero.
BOOST_AUTO_TEST_CASE(zero_equality_rows_do_not_prevent_a_solution) {
  for (int seed = 0; seed < 50; ++seed) {
    RandomQp random(seed, 30, 18, 88);
    random.problem.A.middleRows<3>(6 + 3 * (seed % 4)).setZero();
    random.problem.b.segment<3>(6 + 3 * (seed % 4)).setZero();
    const ActiveSetRun s(random.problem);
    BOOST_TEST((s.outcome == Outcome::kSolved));
    BOOST_TEST(residual(random.problem, s) < 1e-8);
  }
}

// Rounding moves an active row off its bound by more than the violation tolerance used here.
BOOST_AUTO_TEST_CASE(rounding_on_active_rows_does_not_change_the_active_set) {
  for (const double tolerance : {1e-11, 1e-10, 1e-9}) {
    for (const double rest : {1e-2, 1e-3, 1e-4}) {
      for (int seed = 0; seed < 50; ++seed) {
        const QpProblem p = ill_conditioned(seed, rest);
        ActiveSetRun s(p, tolerance);
        BOOST_TEST((s.outcome == Outcome::kSolved));
        BOOST_TEST((s.method.solve(p, tolerance, s.x, s.y, s.z) == Outcome::kSolved));
        BOOST_TEST(s.method.iterations() == 1);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(any_initial_active_set_leads_to_the_same_solution) {
  for (int seed = 0; seed < 100; ++seed) {
    const RandomQp random(seed), other(seed + 1000);
    const ActiveSetRun s(random.problem), other_solution(other.problem);
    ActiveSet method(12, 0, int(random.problem.l.size()));
    Eigen::VectorXd x = s.x, y, z = other_solution.z;
    BOOST_TEST((method.solve(random.problem, 1e-10, x, y, z) == Outcome::kSolved));
    BOOST_TEST((s.x - x).norm() < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(sixteen_constraints_through_one_vertex_are_solved) {
  // The tip of a cone with 16 facets, as in the friction cone of a foot without load.
  QpProblem p = projection_qp(Eigen::Vector3d(0.3, 0.1, -2.0), 16);
  for (int k = 0; k < 16; ++k) {
    const double angle = 2.0 * M_PI * k / 16;
    p.C.row(k) << std::cos(angle), std::sin(angle), -0.6;
    p.u[k] = 0.0;
  }
  const ActiveSetRun s(p);
  BOOST_TEST((s.outcome == Outcome::kSolved));
  BOOST_TEST(s.x.norm() < 1e-12);
  BOOST_TEST(residual(p, s) < 1e-9);
}

BOOST_AUTO_TEST_CASE(contradictory_constraints_are_reported_as_infeasible) {
  QpProblem p = projection_qp(Eigen::Vector2d(1.0, 1.0), 2);
  p.C << 1.0, 0.0, 1.0, 0.0;
  p.u[0] = -1.0;
  p.l[1] = 0.5;
  BOOST_TEST((ActiveSetRun(p).outcome == Outcome::kInfeasible));
}

BOOST_AUTO_TEST_CASE(row_with_lower_bound_above_upper_bound_is_infeasible) {
  QpProblem p = projection_qp(Eigen::Vector2d(1.0, 1.0), 1);
  p.C << 1.0, 0.0;
  p.u[0] = 0.0;
  p.l[0] = 0.5;
  BOOST_TEST((ActiveSetRun(p).outcome == Outcome::kInfeasible));
}

BOOST_AUTO_TEST_CASE(nearly_parallel_constraints_are_not_reported_as_infeasible) {
  QpProblem p = projection_qp(Eigen::Vector2d(0.0, 0.0), 2);
  p.C << 1.0, 0.0, 1.0, 1e-5;
  p.u[0] = 0.0;
  p.l[1] = 1e-6;  // (0, 0.1) satisfies both rows
  BOOST_TEST((ActiveSetRun(p, 1e-6).outcome == Outcome::kGaveUp));
  BOOST_TEST((ActiveSetRun(p, 1e-9).outcome == Outcome::kGaveUp));
  p.C(1, 1) = 0.0;  // now no point satisfies both rows
  BOOST_TEST((ActiveSetRun(p, 1e-6).outcome == Outcome::kInfeasible));
}

BOOST_AUTO_TEST_CASE(number_of_active_set_changes_is_limited) {
  for (const int max_changes : {0, 1, 5}) {
    int ended = 0;
    for (int seed = 0; seed < 50; ++seed) {
      const RandomQp random(seed), other(seed + 1000);
      const ActiveSetRun other_solution(other.problem);
      ActiveSet method(12, 0, int(random.problem.l.size()), max_changes);
      Eigen::VectorXd x = other_solution.x, y, z = other_solution.z;
      ended += method.solve(random.problem, 1e-10, x, y, z) == Outcome::kGaveUp;
      BOOST_TEST(method.iterations() <= max_changes + 1);
    }
    BOOST_TEST(ended > 0);
  }
}

BOOST_AUTO_TEST_CASE(nonconvex_or_nan_qp_is_not_solved) {
  QpProblem p = projection_qp(Eigen::Vector2d(1.0, 1.0), 1);
  p.C << 1.0, 1.0;
  p.H(1, 1) = -1.0;
  BOOST_TEST((ActiveSetRun(p).outcome == Outcome::kGaveUp));
  p.H(1, 1) = 1.0;
  for (double* number : {&p.H(0, 1), &p.C(0, 1), &p.u[0], &p.l[0], &p.g[1]}) {
    const double kept = *number;
    *number = NAN;
    BOOST_TEST((ActiveSetRun(p).outcome != Outcome::kSolved));
    *number = kept;
  }
}

BOOST_AUTO_TEST_SUITE_END()
