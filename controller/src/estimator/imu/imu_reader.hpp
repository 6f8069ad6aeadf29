// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/estimator_report.hpp"
#include "surefoot/robot_config.hpp"

namespace surefoot {

/// One IMU report in base axes, and what it is worth.
struct ImuReading {
  Vector3 w_base = Vector3::Zero();                  ///< [rad/s] raw rate
  Vector3 f_base = Vector3::Zero();                  ///< [m/s^2] specific force at the IMU
  Quaternion R_world_base = Quaternion::Identity();  ///< the vendor's filter; see has_quaternion
  bool has_quaternion = false;                       ///< of unit length, within 5 %
  /// Reports since the last new sample, this one included: 1 is a fresh one.
  int w_age = 1, f_age = 1;
  bool changed = true;  ///< has anything in the report changed since the last?
  SensorVerdict gyroscope = SensorVerdict::kUnjudged;
  SensorVerdict accelerometer = SensorVerdict::kUnjudged;
  SensorVerdict quaternion = SensorVerdict::kUnjudged;
};

/// Reads the IMU through its mount and notices samples that repeat.
///
/// A sample that repeats is an old one, not a new measurement: an IMU slower than the reports holds
/// its words, and that is no fault for as long as kMaxHoldTime. A gyroscope that stands still for
/// longer while the joints go on reporting new values has stopped. Real-time: yes.
class ImuReader {
 public:
  static constexpr double kRateRange = 34.8;     ///< [rad/s] just short of 2000 deg/s, full scale
  static constexpr double kMaxHoldTime = 0.022;  ///< [s] a 50 Hz sensor repeats for 20 ms

  /// @param joints any numbers that change when the robot reports anew
  void read(const IMU& imu, const RobotConfig& config, const Vector12& joints, double dt,
            ImuReading& out) noexcept;
  void reset() noexcept { *this = ImuReader(); }

 private:
  // How long a signal has stood still while others moved.
  struct StuckVectorDetector {
    Vector3 last = Vector3::Constant(NAN);
    double unchanged_time = 0.0;  // [s]
    int age = 1;                  // reports
    void update(const Vector3& value, bool joints_changed, double dt) noexcept;
    SensorVerdict verdict(double limit) const noexcept;
  };
  StuckVectorDetector gyroscope_, accelerometer_;
  Vector12 last_joints_ = Vector12::Constant(NAN);
};

}  // namespace surefoot
