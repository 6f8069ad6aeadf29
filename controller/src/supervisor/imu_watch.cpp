// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/imu_watch.hpp"

#include <algorithm>

#include "estimator/imu/imu_reader.hpp"
#include "low_state_check.hpp"

namespace surefoot {

namespace {

constexpr double kJump = 0.1;       // [rad] of the attitude more than the gyroscope turned
constexpr double kLate = 0.02;      // [s] of its rate that the attitude may be late
constexpr double kForget = 0.5;     // [s] after which a new attitude is taken as it is
constexpr double kRateJump = 3.0;   // [rad/s] of the gyroscope from one report to the next
constexpr double kPatience = 0.05;  // [s] of a gyroscope that stands still or clips
constexpr double kOff = 0.08;       // [rad/s] that it may be off the attitude's rate for long ...
constexpr double kMad = 0.8;        // [rad/s] no report is taken to be further off: a few are none
constexpr double kOffShare = 0.05;  // of its rate, where bodies roll over: it is scaled
constexpr double kOffTime = 0.5;    // [s] ... smoothed over this: pushes tilt attitude filters

}  // namespace

void ImuWatch::update(const IMU& imu, double step, bool anew, bool may_roll) noexcept {
  const std::array<float, 4> q = imu.quaternion;  // packed: copied
  const std::array<float, 3> rates = imu.gyroscope;
  const Vector3 w(rates[0], rates[1], rates[2]);
  rates_fit_ = !started_ || (w - w_last_).norm() < kRateJump;
  const double angle = w.norm() * step;
  if (angle > 0.0) R_ = R_ * Quaternion(Eigen::AngleAxisd(angle, w.normalized()));
  against_ += step;
  const bool before = attitude_fits_;
  attitude_fits_ = has_quaternion(imu);
  if (attitude_fits_) {
    const Quaternion now = Quaternion(q[0], q[1], q[2], q[3]).normalized();
    const Eigen::AngleAxisd turned(last_.conjugate() * now);
    // From one attitude to the next, both believed; across a jump there is no rate.
    const bool timed = started_ && before && step > 0.0;
    const Vector3 w_attitude = timed ? Vector3(turned.angle() / step * turned.axis()) : w;
    last_ = now;
    attitude_fits_ = !started_ || against_ >= kForget || follows(now, w);
    if (attitude_fits_) {
      const double blend = -std::expm1(-step / kOffTime);
      const Vector3 apart = w - w_attitude;
      off_ += blend * (apart * std::min(1.0, kMad / (apart.norm() + 1e-9)) - off_);
      rate_ += blend * (w.norm() - rate_);
      R_ = now;
      against_ = 0.0;
      started_ = true;
    }
  }
  judge_rates(w, step, anew, kOff + (may_roll ? kOffShare * rate_ : 0.0));
  const std::array<float, 3> a = imu.accelerometer;
  judge_accelerometer(Vector3(a[0], a[1], a[2]), step, anew);
}

bool ImuWatch::follows(const Quaternion& attitude, const Vector3& w) const noexcept {
  return attitude.angularDistance(R_) < kJump + kLate * w.norm();
}

void ImuWatch::judge_rates(const Vector3& w, double step, bool anew, double most_off) noexcept {
  // A report that repeats as a whole says nothing of the gyroscope.
  const bool held = held_.update(w == w_last_, anew ? step : 0.0, kPatience);
  const bool clipped =
      clipped_.update(w.cwiseAbs().maxCoeff() >= ImuReader::kRateRange, step, kPatience);
  const bool away = away_.update(off_.norm() > most_off, step, kPatience);
  gyroscope_bad_ = held || clipped || away;
  w_last_ = w;
}

void ImuWatch::judge_accelerometer(const Vector3& a, double step, bool anew) noexcept {
  accelerometer_bad_ = a_held_.update(a == a_last_, anew ? step : 0.0, kPatience);
  a_last_ = a;
}

}  // namespace surefoot
