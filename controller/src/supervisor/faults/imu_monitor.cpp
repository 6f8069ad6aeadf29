// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/faults/imu_monitor.hpp"

#include <algorithm>

#include "estimator/imu/imu_reader.hpp"
#include "low_level/low_state_check.hpp"

namespace surefoot {

namespace {

constexpr double kMaxAttitudeJump = 0.1;  // [rad] of the attitude more than the gyroscope turned
constexpr double kAttitudeDelay = 0.02;   // [s] of its rate that the attitude may be late
constexpr double kReacceptTime = 0.5;     // [s] after which a new attitude is taken as it is
constexpr double kMaxRateJump = 3.0;      // [rad/s] of the gyroscope from one report to the next
constexpr double kHeldTime = 0.05;        // [s] of a gyroscope that stands still or clips
constexpr double kMaxRateError =
    0.08;  // [rad/s] that it may be off the attitude's rate for long ...
constexpr double kRateErrorClamp =
    0.8;  // [rad/s] no report is taken to be further off: a few are none
constexpr double kScaleErrorShare = 0.05;  // of its rate, where bodies roll over: it is scaled
constexpr double kRateErrorTime = 0.5;  // [s] ... smoothed over this: pushes tilt attitude filters

}  // namespace

void ImuMonitor::update(const IMU& imu, double step, bool changed, bool may_turn_fast) noexcept {
  const std::array<float, 4> q = imu.quaternion;  // packed: copied
  const std::array<float, 3> rates = imu.gyroscope;
  const Vector3 w(rates[0], rates[1], rates[2]);
  rates_plausible_ = !started_ || (w - w_last_).norm() < kMaxRateJump;
  const double angle = w.norm() * step;
  if (angle > 0.0) R_ = R_ * Quaternion(Eigen::AngleAxisd(angle, w.normalized()));
  rejected_time_ += step;
  const bool before = attitude_plausible_;
  attitude_plausible_ = has_unit_quaternion(imu);
  if (attitude_plausible_) {
    const Quaternion attitude = Quaternion(q[0], q[1], q[2], q[3]).normalized();
    const Eigen::AngleAxisd turned(last_attitude_.conjugate() * attitude);
    // From one attitude to the next, both believed; across a jump there is no rate.
    const bool timed = started_ && before && step > 0.0;
    const Vector3 w_attitude = timed ? Vector3(turned.angle() / step * turned.axis()) : w;
    last_attitude_ = attitude;
    attitude_plausible_ =
        !started_ || rejected_time_ >= kReacceptTime || is_consistent(attitude, w);
    if (attitude_plausible_) {
      const double blend = -std::expm1(-step / kRateErrorTime);
      const Vector3 rate_error = w - w_attitude;
      rate_error_ +=
          blend *
          (rate_error * std::min(1.0, kRateErrorClamp / (rate_error.norm() + 1e-9)) - rate_error_);
      mean_rate_ += blend * (w.norm() - mean_rate_);
      R_ = attitude;
      rejected_time_ = 0.0;
      started_ = true;
    }
  }
  judge_rates(w, step, changed,
              kMaxRateError + (may_turn_fast ? kScaleErrorShare * mean_rate_ : 0.0));
  const std::array<float, 3> a = imu.accelerometer;
  judge_accelerometer(Vector3(a[0], a[1], a[2]), step, changed);
}

bool ImuMonitor::is_consistent(const Quaternion& attitude, const Vector3& w) const noexcept {
  return attitude.angularDistance(R_) < kMaxAttitudeJump + kAttitudeDelay * w.norm();
}

void ImuMonitor::judge_rates(const Vector3& w, double step, bool changed,
                             double max_error) noexcept {
  // A report that repeats as a whole says nothing of the gyroscope.
  const bool held = gyroscope_held_.update(w == w_last_, changed ? step : 0.0, kHeldTime);
  const bool clipped =
      gyroscope_clipped_.update(w.cwiseAbs().maxCoeff() >= ImuReader::kRateRange, step, kHeldTime);
  const bool inconsistent =
      rate_inconsistent_.update(rate_error_.norm() > max_error, step, kHeldTime);
  gyroscope_bad_ = held || clipped || inconsistent;
  w_last_ = w;
}

void ImuMonitor::judge_accelerometer(const Vector3& a, double step, bool changed) noexcept {
  accelerometer_bad_ = accelerometer_held_.update(a == a_last_, changed ? step : 0.0, kHeldTime);
  a_last_ = a;
}

}  // namespace surefoot
