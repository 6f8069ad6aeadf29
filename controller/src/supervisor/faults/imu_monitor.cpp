// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/faults/imu_monitor.hpp"

#include <algorithm>

#include "estimator/imu/imu_reader.hpp"
#include "low_level/low_state_check.hpp"

namespace surefoot {

namespace {

// The constants are chosen by hand. The rows imu_bias, imu_dropout, attitude_jump and
// duplicate_data of `surefoot faults` bracket the values: in these rows a value that "passes" must
// not be reported, and a value that "is a fault" must be. benchmarks/false_trips.py checks that
// healthy robots pass.
//
// [rad] Angle between the measured attitude and the attitude propagated by the gyroscope above
// which the measured attitude has jumped. Smaller than the jump of 10 degrees (0.17 rad) in the row
// attitude_jump.
constexpr double kMaxAttitudeJump = 0.1;
// [s] Delay of the measured attitude, compared with the gyroscope, that is no fault. This delay
// times the angular speed is added to kMaxAttitudeJump.
constexpr double kAttitudeDelay = 0.02;
// [s] Any attitude is accepted after attitudes have been rejected for this time.
constexpr double kReacceptTime = 0.5;
// [rad/s] Change of the gyroscope between two samples above which the gyroscope has jumped: an
// offset of 2.5 rad/s passes, noise of up to 10 rad/s is a fault.
constexpr double kMaxRateJump = 3.0;
// [rad/s] The same while feet step: the vibration after hard landings changes the gyroscope by up
// to 9 rad/s (go1 and b1, ten random walks each, on blocks and steps).
constexpr double kMaxSteppingRateJump = 12.0;
// [rad/s], [s] Mean change of the gyroscope between two samples, over this time, above which a
// stepping robot's gyroscope is noise. Vibration dies out within 30 ms, so its mean stays below 3;
// the mean of noise of up to 10 rad/s exceeds the limit after 7 ms.
constexpr double kMaxMeanRateJump = 4.0, kRateJumpTime = 0.02;
// [s] Time for which a signal must be bad before it is a fault. Longer than 18 ms, for which an IMU
// that is read at 50 Hz repeats its values.
constexpr double kMinBadTime = 0.05;
// [rad/s] Mean difference between gyroscope and rate of the attitude above which the gyroscope is
// wrong: 0.02 passes, 0.1 is a fault within 1 s.
constexpr double kMaxRateError = 0.08;
// [rad/s] Limit of the difference in one sample: ten times kMaxRateError. So 10 ms of outliers
// change the mean by at most 0.8 (10 ms / kRateErrorTime) = 0.016.
constexpr double kRateErrorClamp = 0.8;
// Tolerance for an error of the gyroscope's scale, as a share of the mean rate, added to
// kMaxRateError. Large enough for a healthy b1 that rolls over while its legs fold.
constexpr double kScaleErrorShare = 0.05;
// [s] Time constant of the mean difference. Longer than pushes (0.1 s), which disturb the attitude
// filter. Shorter than 1 s, within which the fault must be found.
constexpr double kRateErrorTime = 0.5;

}  // namespace

void ImuMonitor::update(const IMU& imu, double step, bool changed, ImuMotion motion) noexcept {
  const std::array<float, 4> q = imu.quaternion;  // the field is packed, so it is copied
  const std::array<float, 3> rates = imu.gyroscope;
  const Vector3 w(rates[0], rates[1], rates[2]);
  rates_plausible_ = !started_ || judge_rate_jump((w - w_last_).norm(), step, motion);
  const double angle = w.norm() * step;
  if (angle > 0.0)
    R_propagated_ = R_propagated_ * Quaternion(Eigen::AngleAxisd(angle, w.normalized()));
  rejected_time_ += step;
  const bool was_plausible = attitude_plausible_;
  attitude_plausible_ = has_unit_quaternion(imu);
  if (attitude_plausible_) {
    const Quaternion attitude = Quaternion(q[0], q[1], q[2], q[3]).normalized();
    const Eigen::AngleAxisd rotation(last_attitude_.conjugate() * attitude);
    // The rate of the attitude needs two plausible attitudes; across a jump it has no meaning.
    const bool rate_known = started_ && was_plausible && step > 0.0;
    const Vector3 w_attitude = rate_known ? Vector3(rotation.angle() / step * rotation.axis()) : w;
    last_attitude_ = attitude;
    attitude_plausible_ =
        !started_ || rejected_time_ >= kReacceptTime || is_consistent(attitude, w);
    if (attitude_plausible_) {
      const double blend = -std::expm1(-step / kRateErrorTime);
      const Vector3 rate_error = w - w_attitude;  // 1e-9 below avoids a division by zero
      rate_error_ +=
          blend *
          (rate_error * std::min(1.0, kRateErrorClamp / (rate_error.norm() + 1e-9)) - rate_error_);
      mean_rate_ += blend * (w.norm() - mean_rate_);
      R_propagated_ = attitude;
      rejected_time_ = 0.0;
      started_ = true;
    }
  }
  judge_rates(w, step, changed,
              kMaxRateError + (motion != ImuMotion::kStands ? kScaleErrorShare * mean_rate_ : 0.0));
  const std::array<float, 3> a = imu.accelerometer;
  judge_accelerometer(Vector3(a[0], a[1], a[2]), step, changed);
}

bool ImuMonitor::judge_rate_jump(double jump, double step, ImuMotion motion) noexcept {
  mean_rate_jump_ -= std::expm1(-step / kRateJumpTime) * (jump - mean_rate_jump_);
  if (motion != ImuMotion::kSteps) return jump < kMaxRateJump;
  return jump < kMaxSteppingRateJump && mean_rate_jump_ < kMaxMeanRateJump;
}

bool ImuMonitor::is_consistent(const Quaternion& attitude, const Vector3& w) const noexcept {
  return attitude.angularDistance(R_propagated_) < kMaxAttitudeJump + kAttitudeDelay * w.norm();
}

void ImuMonitor::judge_rates(const Vector3& w, double step, bool changed,
                             double max_error) noexcept {
  // If the whole sample repeats, the gyroscope has no fault, so the time is not counted.
  const bool repeated = gyroscope_repeats_.update(w == w_last_, changed ? step : 0.0, kMinBadTime);
  const bool clipped =
      gyroscope_clips_.update(w.cwiseAbs().maxCoeff() >= ImuReader::kRateRange, step, kMinBadTime);
  const bool inconsistent =
      rate_inconsistent_.update(rate_error_.norm() > max_error, step, kMinBadTime);
  gyroscope_bad_ = repeated || clipped || inconsistent;
  w_last_ = w;
}

void ImuMonitor::judge_accelerometer(const Vector3& a, double step, bool changed) noexcept {
  accelerometer_bad_ =
      accelerometer_repeats_.update(a == a_last_, changed ? step : 0.0, kMinBadTime);
  a_last_ = a;
}

}  // namespace surefoot
