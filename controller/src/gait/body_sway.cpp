// SPDX-License-Identifier: BSD-3-Clause
#include "gait/body_sway.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "reference/support_polygon.hpp"

namespace surefoot {

namespace {

// Samples of the preview, and their distance [sqrt(h/g)]. The preview is 4 sqrt(h/g) long: what
// comes later changes the DCM by exp(-4) = 2 %.
constexpr int kSamples = 40;
constexpr double kSampleTime = 0.1;
// Feedback of the DCM error to the ZMP, beyond the 1 that keeps the error constant. Chosen: the
// error falls with the time constant sqrt(h/g).
constexpr double kFeedback = 1.0;
// Share of the margin that the ZMP keeps while the feedback moves it. Chosen.
constexpr double kFeedbackMargin = 0.5;
// is_at_rest(): [h] largest distance of the DCM from the body trajectory, 3 mm at h = 0.3 m.
constexpr double kRestDistance = 0.01;

// Return the share, 0 .. 1, of the support triangle without this foot in the planned ZMP.
double swing_share(const NextSwing& swing, double time, double shift_time) noexcept {
  const double ramp = std::max(shift_time, 1e-6);
  double outside = 0.0;  // [s] time until or since the nearest swing
  if (time < swing.begin) {
    outside = swing.begin - time;
    if (swing.begin > 0.0) outside = std::min(outside, swing.landed + time);
  } else if (time > swing.end) {
    outside = time - swing.end;
  }
  return std::max(1.0 - outside / ramp, 0.0);
}

// The planned ZMP relative to that of the body trajectory, as a function of time.
class PlannedZmp {
 public:
  PlannedZmp(const BodySway::Input& input, double time_unit) noexcept
      : input_(input),
        square_time_(time_unit * time_unit),
        zmp_(input.p - square_time_ * (input.a - input.change.a)) {}

  Eigen::Vector2d operator()(double time) noexcept {
    Eigen::Vector2d base = zmp_ + time * input_.v + input_.change.moved(time);
    if (time < input_.change.time_left) base -= square_time_ * input_.change.a;
    std::array<double, kLegs> share;
    double sum = 0.0;
    for (int leg = 0; leg < kLegs; ++leg) {
      share[leg] = swing_share(input_.swings[leg], time, input_.shift_time);
      sum += share[leg];
    }
    Eigen::Vector2d zmp = Eigen::Vector2d::Zero();
    for (int leg = 0; leg < kLegs; ++leg) {
      if (share[leg] == 0.0) continue;
      const Eigen::Vector2d inside = triangle(leg, time).nearest_inside(base, input_.margin);
      zmp += share[leg] / std::max(sum, 1.0) * (inside - base);
    }
    return zmp;
  }

 private:
  // Return the support triangle without a foot. It changes only when another foot lifts off, so
  // that most samples of the preview use the one before.
  const SupportPolygon& triangle(int without, double time) noexcept {
    unsigned lifted = 0;  // one bit per foot
    std::array<bool, kLegs> others = {true, true, true, true};
    others[without] = false;
    for (int leg = 0; leg < kLegs; ++leg) {
      if (others[leg] && time >= input_.swings[leg].begin) lifted |= 1U << leg;
    }
    if (!triangles_[without] || lifted_[without] != lifted) {
      FeetMatrix feet = FeetMatrix::Zero();
      for (int leg = 0; leg < kLegs; ++leg) {
        const NextSwing& swing = input_.swings[leg];
        feet.col(leg).head<2>() = (lifted >> leg & 1U) != 0 ? swing.to : swing.from;
      }
      triangles_[without].emplace(feet, others);
      lifted_[without] = lifted;
    }
    return *triangles_[without];
  }

  const BodySway::Input& input_;
  double square_time_;   // [s^2] h / g
  Eigen::Vector2d zmp_;  // of the body trajectory at time 0, without the change of its velocity
  std::array<std::optional<SupportPolygon>, kLegs> triangles_;
  std::array<unsigned, kLegs> lifted_{};
};

}  // namespace

void BodySway::update(const Input& input, double dt) noexcept {
  const double omega = 1.0 / size_.time;
  // Integrate the DCM backwards over the preview: dxi/dt = omega (xi - zmp).
  const double kept = std::exp(-kSampleTime);
  const double step = kSampleTime * size_.time;
  PlannedZmp planned_zmp(input, size_.time);
  Eigen::Vector2d planned_dcm = planned_zmp(kSamples * step);
  for (int k = kSamples - 1; k >= 0; --k) {
    planned_dcm = kept * planned_dcm + (1.0 - kept) * planned_zmp((k + 0.5) * step);
  }
  const Eigen::Vector2d error = p_ + v_ / omega - planned_dcm;
  Eigen::Vector2d zmp = planned_zmp(0.0) + (1.0 + kFeedback) * error;
  const SupportPolygon support = [&] {
    FeetMatrix feet = FeetMatrix::Zero();
    for (int leg = 0; leg < kLegs; ++leg) feet.col(leg).head<2>() = input.swings[leg].from;
    return SupportPolygon(feet, input.stance);
  }();
  if (support.is_valid()) {
    const Eigen::Vector2d base = input.p - input.a / (omega * omega);
    zmp = support.nearest_inside(base + zmp, kFeedbackMargin * input.margin) - base;
  }
  a_ = omega * omega * (p_ - zmp);
  p_ += dt * (v_ + 0.5 * dt * a_);
  v_ += dt * a_;
}

bool BodySway::is_at_rest() const noexcept {
  return (p_ + size_.time * v_).norm() < kRestDistance * size_.height &&
         p_.norm() < kRestDistance * size_.height;
}

}  // namespace surefoot
