// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/estimator_report.hpp"
#include "surefoot/robot_config.hpp"

namespace surefoot {

/// One IMU sample in base axes, with a verdict on each sensor.
struct ImuReading {
  Vector3 w_base = Vector3::Zero();  ///< [rad/s] as measured, bias included
  /// [m/s^2] Specific force at the IMU, bias included.
  Vector3 f_base = Vector3::Zero();
  Quaternion R_world_base = Quaternion::Identity();  ///< valid if has_quaternion
  /// True if the IMU quaternion has norm 1, within 5 %.
  bool has_quaternion = false;
  /// Number of samples that have had the present value, this sample included; 1: the value is new.
  int w_age = 1, f_age = 1;
  /// True if joints, gyroscope or accelerometer differ from the last sample.
  bool changed = true;
  SensorVerdict gyroscope = SensorVerdict::kUnjudged;
  SensorVerdict accelerometer = SensorVerdict::kUnjudged;
  SensorVerdict quaternion = SensorVerdict::kUnjudged;
};

/// Converts IMU samples to base axes and detects values that repeat.
///
/// An IMU that measures less often than samples arrive repeats its values. This is no fault for up
/// to kMaxHoldTime. A signal that is constant for longer, while the joint values change, gets the
/// verdict kZero or kConstant. Real-time: yes.
class ImuReader {
 public:
  /// [rad/s] The gyroscope counts as saturated from this rate on. Derived: just below 2000 deg/s
  /// (34.9), its assumed full scale.
  static constexpr double kRateRange = 34.8;
  /// [s] Longest time for which a working sensor repeats a value. Derived: 20 ms of a 50 Hz sensor,
  /// plus one tick at 500 Hz. Test: sensor_is_constant_after_22_ms_of_joint_motion.
  static constexpr double kMaxHoldTime = 0.022;

  /// Process one sample.
  /// @param joints any values that change with every new sample, for example q + dq
  void read(const IMU& imu, const RobotConfig& config, const Vector12& joints, double dt,
            ImuReading& out) noexcept;
  void reset() noexcept { *this = ImuReader(); }

 private:
  // Measures how long a signal has been constant while the joints changed.
  struct StuckVectorDetector {
    Vector3 last = Vector3::Constant(NAN);
    double unchanged_time = 0.0;  // [s]
    int age = 1;                  // [samples]
    void update(const Vector3& value, bool joints_changed, double dt) noexcept;
    SensorVerdict verdict(double limit) const noexcept;
  };
  StuckVectorDetector gyroscope_, accelerometer_;
  Vector12 last_joints_ = Vector12::Constant(NAN);
};

}  // namespace surefoot
