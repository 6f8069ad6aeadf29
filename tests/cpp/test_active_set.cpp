// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "kkt.hpp"
#include "wbc/active_set.hpp"

using namespace surefoot;

namespace {

using Outcome = ActiveSet::Outcome;

struct Solved {
  explicit Solved(const QpProblem& p, double tolerance = 1e-10)
      : method(int(p.g.size()), int(p.b.size()), int(p.l.size())), x(p.g), y(p.b), z(p.l) {
    z.setZero();
    outcome = method.solve(p, tolerance, x, y, z);
  }
  ActiveSet method;
  Eigen::VectorXd x, y, z;
  Outcome outcome;
};

double residual(const QpProblem& p, const Solved& s) { return kkt_residual(p, s.x, s.y, s.z); }

// Minimise |x - target|^2 / 2 within rows.
QpProblem nearest(const Eigen::VectorXd& target, int rows) {
  QpProblem p(int(target.size()), 0, rows);
  p.H.setIdentity();
  p.g = -target;
  p.l.setConstant(-kNoBound);
  p.u.setConstant(kNoBound);
  return p;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(active_set)

BOOST_AUTO_TEST_CASE(random_programs_are_solved_from_nothing) {
  for (int seed = 0; seed < 500; ++seed) {
    const RandomProgram random(seed);
    const Solved s(random.problem);
    BOOST_REQUIRE((s.outcome == Outcome::kSolved));
    BOOST_TEST(residual(random.problem, s) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(the_rows_of_the_answer_are_the_answers_again_at_once) {
  for (int seed = 0; seed < 50; ++seed) {
    const RandomProgram random(seed);
    Solved s(random.problem);
    const Eigen::VectorXd x = s.x;
    BOOST_TEST((s.method.solve(random.problem, 1e-10, s.x, s.y, s.z) == Outcome::kSolved));
    BOOST_TEST(s.method.iterations() == 1);
    BOOST_TEST((s.x - x).norm() < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(equalities_hold_whatever_their_multipliers) {
  for (int seed = 0; seed < 100; ++seed) {
    const RandomProgram random(seed, 30, 18, 88);
    const Solved s(random.problem);
    BOOST_TEST((s.outcome == Outcome::kSolved));
    BOOST_TEST(residual(random.problem, s) < 1e-8);
  }
}

// A soft foot's rows say nothing.
BOOST_AUTO_TEST_CASE(equalities_of_nothing_are_no_trouble) {
  for (int seed = 0; seed < 50; ++seed) {
    RandomProgram random(seed, 30, 18, 88);
    random.problem.A.middleRows<3>(6 + 3 * (seed % 4)).setZero();
    random.problem.b.segment<3>(6 + 3 * (seed % 4)).setZero();
    const Solved s(random.problem);
    BOOST_TEST((s.outcome == Outcome::kSolved));
    BOOST_TEST(residual(random.problem, s) < 1e-8);
  }
}

// A row on its bound is off it by rounding, which is more than what counts as violated here.
BOOST_AUTO_TEST_CASE(rounding_of_active_rows_makes_no_row_change) {
  for (const double tolerance : {1e-11, 1e-10, 1e-9}) {
    for (const double rest : {1e-2, 1e-3, 1e-4}) {
      for (int seed = 0; seed < 50; ++seed) {
        const QpProblem p = ill_conditioned(seed, rest);
        Solved s(p, tolerance);
        BOOST_TEST((s.outcome == Outcome::kSolved));
        BOOST_TEST((s.method.solve(p, tolerance, s.x, s.y, s.z) == Outcome::kSolved));
        BOOST_TEST(s.method.iterations() == 1);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(any_rows_to_begin_with_lead_to_the_same_answer) {
  for (int seed = 0; seed < 100; ++seed) {
    const RandomProgram random(seed), other(seed + 1000);
    const Solved s(random.problem), wrong(other.problem);
    ActiveSet method(12, 0, int(random.problem.l.size()));
    Eigen::VectorXd x = s.x, y, z = wrong.z;
    BOOST_TEST((method.solve(random.problem, 1e-10, x, y, z) == Outcome::kSolved));
    BOOST_TEST((s.x - x).norm() < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(rows_that_meet_in_one_point_are_no_trouble) {
  // The tip of a cone with sixteen facets, as a foot that carries nothing has it.
  QpProblem p = nearest(Eigen::Vector3d(0.3, 0.1, -2.0), 16);
  for (int k = 0; k < 16; ++k) {
    const double angle = 2.0 * M_PI * k / 16;
    p.C.row(k) << std::cos(angle), std::sin(angle), -0.6;
    p.u[k] = 0.0;
  }
  const Solved s(p);
  BOOST_TEST((s.outcome == Outcome::kSolved));
  BOOST_TEST(s.x.norm() < 1e-12);
  BOOST_TEST(residual(p, s) < 1e-9);
}

BOOST_AUTO_TEST_CASE(rows_that_cannot_all_hold_are_called_so) {
  QpProblem p = nearest(Eigen::Vector2d(1.0, 1.0), 2);
  p.C << 1.0, 0.0, 1.0, 0.0;
  p.u[0] = -1.0;
  p.l[1] = 0.5;
  BOOST_TEST((Solved(p).outcome == Outcome::kInfeasible));
}

BOOST_AUTO_TEST_CASE(a_row_whose_bounds_contradict_each_other_is_called_so) {
  QpProblem p = nearest(Eigen::Vector2d(1.0, 1.0), 1);
  p.C << 1.0, 0.0;
  p.u[0] = 0.0;
  p.l[0] = 0.5;
  BOOST_TEST((Solved(p).outcome == Outcome::kInfeasible));
}

BOOST_AUTO_TEST_CASE(rows_that_are_nearly_parallel_are_not_called_contradictory) {
  QpProblem p = nearest(Eigen::Vector2d(0.0, 0.0), 2);
  p.C << 1.0, 0.0, 1.0, 1e-5;
  p.u[0] = 0.0;
  p.l[1] = 1e-6;  // (0, 0.1) satisfies both
  BOOST_TEST((Solved(p, 1e-6).outcome == Outcome::kGaveUp));
  BOOST_TEST((Solved(p, 1e-9).outcome == Outcome::kGaveUp));
  p.C(1, 1) = 0.0;  // now nothing does
  BOOST_TEST((Solved(p, 1e-6).outcome == Outcome::kInfeasible));
}

BOOST_AUTO_TEST_CASE(no_more_rows_change_than_it_is_told) {
  for (const int most : {0, 1, 5}) {
    int ended = 0;
    for (int seed = 0; seed < 50; ++seed) {
      const RandomProgram random(seed), other(seed + 1000);
      const Solved wrong(other.problem);
      ActiveSet method(12, 0, int(random.problem.l.size()), most);
      Eigen::VectorXd x = wrong.x, y, z = wrong.z;
      ended += method.solve(random.problem, 1e-10, x, y, z) == Outcome::kGaveUp;
      BOOST_TEST(method.iterations() <= most + 1);
    }
    BOOST_TEST(ended > 0);
  }
}

BOOST_AUTO_TEST_CASE(what_is_not_convex_or_no_number_is_given_up) {
  QpProblem p = nearest(Eigen::Vector2d(1.0, 1.0), 1);
  p.C << 1.0, 1.0;
  p.H(1, 1) = -1.0;
  BOOST_TEST((Solved(p).outcome == Outcome::kGaveUp));
  p.H(1, 1) = 1.0;
  for (double* number : {&p.H(0, 1), &p.C(0, 1), &p.u[0], &p.l[0], &p.g[1]}) {
    const double kept = *number;
    *number = NAN;
    BOOST_TEST((Solved(p).outcome != Outcome::kSolved));
    *number = kept;
  }
}

BOOST_AUTO_TEST_SUITE_END()
