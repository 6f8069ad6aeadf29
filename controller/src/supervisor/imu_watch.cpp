// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/imu_watch.hpp"

#include "low_state_check.hpp"

namespace surefoot {

namespace {

constexpr double kJump = 0.1;       // [rad] of the attitude more than the gyroscope turned
constexpr double kLate = 0.02;      // [s] of its rate that the attitude may be late
constexpr double kForget = 0.5;     // [s] after which a new attitude is taken as it is
constexpr double kRateJump = 3.0;   // [rad/s] between gyroscope and the attitude's own rate
constexpr double kClipped = 34.8;   // [rad/s] full scale of 2000 deg/s, just short of it
constexpr double kPatience = 0.05;  // [s] of a gyroscope that stands still or clips
constexpr double kOff = 0.08;       // [rad/s] that it may be off the attitude's rate for long ...
constexpr double kOffTime = 0.5;    // [s] ... smoothed over this: pushes tilt attitude filters

}  // namespace

bool ImuWatch::update(const IMU& imu, double step, bool anew) noexcept {
  const std::array<float, 4> q = imu.quaternion;  // packed: copied
  const std::array<float, 3> rates = imu.gyroscope;
  const Vector3 w(rates[0], rates[1], rates[2]);
  const double angle = w.norm() * step;
  if (angle > 0.0) R_ = R_ * Quaternion(Eigen::AngleAxisd(angle, w.normalized()));
  against_ += step;
  if (!has_quaternion(imu)) {
    compare_rates(w, w - off_, step, anew);  // nothing to compare with
    return false;
  }
  const Quaternion now = Quaternion(q[0], q[1], q[2], q[3]).normalized();
  const Eigen::AngleAxisd turned(last_.conjugate() * now);
  const bool timed = started_ && step > 0.0;
  const Vector3 w_attitude = timed ? Vector3(turned.angle() / step * turned.axis()) : w;
  last_ = now;
  const bool clipped = w.cwiseAbs().maxCoeff() >= kClipped;
  const bool jumps = !clipped && (w - w_attitude).norm() > kRateJump && against_ < kForget;
  if (!jumps && !clipped) compare_rates(w, w_attitude, step, anew);
  gyroscope_bad_ |= clipped_.update(clipped, step, kPatience);
  const bool follows = clipped || now.angularDistance(R_) < kJump + kLate * w.norm();
  if (started_ && against_ < kForget && (jumps || !follows)) return false;
  R_ = now;
  started_ = true;
  against_ = 0.0;
  return true;
}

void ImuWatch::compare_rates(const Vector3& w, const Vector3& w_attitude, double step,
                             bool anew) noexcept {
  off_ += -std::expm1(-step / kOffTime) * (w - w_attitude - off_);
  // A report that repeats as a whole says nothing of the gyroscope.
  const bool held = held_.update(w == w_last_, anew ? step : 0.0, kPatience);
  const bool away = away_.update(off_.norm() > kOff, step, kPatience);
  gyroscope_bad_ = held || away;
  w_last_ = w;
}

}  // namespace surefoot
