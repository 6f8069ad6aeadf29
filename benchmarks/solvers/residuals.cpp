// SPDX-License-Identifier: BSD-3-Clause
#include "residuals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bench {

namespace {

constexpr double kNoBound = 1e20;

double dot(const double* row, const std::vector<double>& x) {
  double sum = 0.0;
  for (std::size_t j = 0; j < x.size(); ++j) sum += row[j] * x[j];
  return sum;
}

void add_row(std::vector<double>& gradient, const double* row, double multiplier) {
  for (std::size_t j = 0; j < gradient.size(); ++j) gradient[j] += multiplier * row[j];
}

bool finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

// The distance of a missing bound is 1, so its gap is the multiplier, limited to 1.
double row_gap(double z, double Cx, double l, double u) {
  const double bound = z > 0.0 ? u : l;
  const double distance = std::abs(bound) < kNoBound ? std::abs(bound - Cx) : 1.0;
  return std::min(std::abs(z), 1.0) * distance;
}

}  // namespace

Residuals residuals(const Problem& p, const Solution& a) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!finite(a.x) || !finite(a.y) || !finite(a.z)) return {kInfinity, kInfinity, kInfinity};
  Residuals r;
  std::vector<double> gradient(p.g, p.g + p.n);
  for (int i = 0; i < p.n; ++i) gradient[i] += dot(p.H + i * p.n, a.x);
  for (int i = 0; i < p.n_eq; ++i) {
    r.primal = std::max(r.primal, std::abs(dot(p.A + i * p.n, a.x) - p.b[i]));
    add_row(gradient, p.A + i * p.n, a.y[i]);
  }
  for (int i = 0; i < p.n_in; ++i) {
    const double Cx = dot(p.C + i * p.n, a.x);
    r.primal = std::max({r.primal, p.l[i] - Cx, Cx - p.u[i]});
    r.gap = std::max(r.gap, row_gap(a.z[i], Cx, p.l[i], p.u[i]));
    add_row(gradient, p.C + i * p.n, a.z[i]);
  }
  for (const double entry : gradient) r.dual = std::max(r.dual, std::abs(entry));
  return r;
}

}  // namespace bench
