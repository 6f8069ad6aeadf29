// SPDX-License-Identifier: BSD-3-Clause
#include "safety/power_limiter.hpp"

#include <cmath>

namespace surefoot {

namespace {

// Number of bisections of [0, 1]. Derived: the last interval is 2^-50, about the resolution of a
// double.
constexpr int kBisections = 50;

/// Power as a function of s: the power of motor i is |a_i + s b_i| [W].
struct PowerLine {
  Vector12 a, b;
  double at(double s) const noexcept { return (a + s * b).cwiseAbs().sum(); }
};

// Return the s in [0, 1] with the smallest power. The power is convex and piecewise linear in s, so
// it is smallest at an end of [0, 1] or at a kink: an s at which a_i + s b_i of a motor is zero.
double min_power_scale(const PowerLine& line) noexcept {
  double best = 0.0;
  const auto consider = [&](double s) {
    if (line.at(s) < line.at(best)) best = s;
  };
  for (int i = 0; i < kMotors; ++i) {
    const double kink = -line.a[i] / line.b[i];
    if (kink > 0.0 && kink < 1.0) consider(kink);
  }
  consider(1.0);
  return best;
}

// Return the largest s whose power is within the limit. Above `least_power_scale`, the s with the
// smallest power, the power never falls, so it crosses the limit at most once.
double max_scale(const PowerLine& line, double limit, double least_power_scale) noexcept {
  if (line.at(1.0) <= limit) return 1.0;
  double below_limit = least_power_scale, above_limit = 1.0;
  for (int k = 0; k < kBisections; ++k) {
    const double middle = 0.5 * (below_limit + above_limit);
    (line.at(middle) <= limit ? below_limit : above_limit) = middle;
  }
  return below_limit;
}

}  // namespace

LimitedTorques limit_power(const Vector12& tau, const Vector12& hold, const Vector12& dq,
                           double limit, double damping) noexcept {
  LimitedTorques out;
  out.torques = tau;
  const PowerLine line{(hold - damping * dq).cwiseProduct(dq), (tau - hold).cwiseProduct(dq)};
  out.power = line.at(1.0);
  // Finite and within the limit: return the torques bit by bit as they are.
  if (out.power <= limit && std::isfinite(out.power)) return out;
  if (!(line.a.allFinite() && line.b.allFinite())) {
    out.torques = hold.unaryExpr([](double x) { return std::isfinite(x) ? x : 0.0; });
    out.scale = 0.0;
    out.power = power_of(out.torques, dq, damping);
    out.no_scale_within_limit = true;
    return out;
  }
  const double least_power_scale = min_power_scale(line);
  out.no_scale_within_limit = !(line.at(least_power_scale) <= limit);
  out.scale = out.no_scale_within_limit ? 0.0 : max_scale(line, limit, least_power_scale);
  out.torques = hold + out.scale * (tau - hold);
  out.power = line.at(out.scale);
  return out;
}

}  // namespace surefoot
