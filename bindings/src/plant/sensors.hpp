// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "plant/imu.hpp"
#include "plant/joint_and_foot_sensors.hpp"

namespace surefoot::plant {

using Doubles = nb::ndarray<double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Indices = Eigen::Array<int, kMotors, 1>;

/// Views of MuJoCo's memory, and the indices of the motors' joints in it.
struct MujocoState {
  Doubles qpos, qvel, qacc, applied, sensordata;  ///< of mujoco.MjData; applied: qfrc_applied
  Indices motor_q, motor_v;  ///< indices of the motors' joints in qpos and in qvel

  static Array12 gather(const Doubles& values, const Indices& at) {
    Array12 out;
    for (int i = 0; i < kMotors; ++i) out[i] = values.data()[at[i]];
    return out;
  }
  Array12 q() const { return gather(qpos, motor_q); }
  Array12 dq() const { return gather(qvel, motor_v); }
  Array12 ddq() const { return gather(qacc, motor_v); }
};

/// Simulated sensors: IMU, encoders, foot force sensors and motor torques. Their readings are
/// combined to a LowState.
class Sensors {
 public:
  /// @param vibration vibration of the IMU; none: it does not vibrate
  /// @param accelerometer_readings number of LowStates for each new accelerometer value
  Sensors(MujocoState state, WireFormat wire, Imu imu, std::optional<Vibration> vibration,
          int accelerometer_readings, Encoders encoders, FootSensors feet,
          const Eigen::Array<int, kLegs * 3, 1>& foot_forces, const Vector3& ground_normal,
          const LowState& rest, std::uint32_t tick0, double rate)
      : state_(std::move(state)),
        wire_(wire),
        imu_(std::move(imu)),
        vibration_(std::move(vibration)),
        accelerometer_readings_(accelerometer_readings),
        encoders_(std::move(encoders)),
        feet_(std::move(feet)),
        foot_forces_(foot_forces),
        ground_normal_(ground_normal),
        frame_(rest),
        tick0_(tick0),
        rate_(rate) {}

  /// Start the attitude filter and the memory of the foot forces, with the robot at rest.
  void start() {
    imu_.start();
    feet_.start(normal_forces());
    if (vibration_) vibration_->start(normal_forces());
  }

  /// Advance by one physics step; dq are the true velocities at the motors [rad/s].
  void step(const Array12& dq) {
    const Array4 forces = normal_forces();
    if (vibration_) vibration_->step(forces);
    imu_.step(vibration_ ? &*vibration_ : nullptr);
    encoders_.step(dq);
    feet_.step(forces);
  }

  /// Return the LowState of the present state. tauEst is the torque that the drivers estimate. Each
  /// call advances the tick by one control period.
  LowState read(const Motors& motors) {
    write_imu();
    write_motors(motors);
    const auto [counts, newtons] = feet_.read(normal_forces());
    frame_.footForce = {counts[0], counts[1], counts[2], counts[3]};
    frame_.footForceEst = {newtons[0], newtons[1], newtons[2], newtons[3]};
    const double elapsed = std::nearbyint(1000.0 * static_cast<double>(readings_++) / rate_);
    frame_.tick = static_cast<std::uint32_t>(tick0_ + static_cast<std::uint64_t>(elapsed));
    return frame_;
  }

 private:
  Array4 normal_forces() const {
    Array4 forces;
    for (int leg = 0; leg < kLegs; ++leg) {
      Vector3 force;
      for (int k = 0; k < 3; ++k) force[k] = state_.sensordata.data()[foot_forces_[3 * leg + k]];
      forces[leg] = force.dot(ground_normal_);
    }
    return forces;
  }
  void write_imu() {
    const Eigen::Vector4f q = imu_.quaternion().cast<float>();
    const Eigen::Vector3f w = imu_.gyro().cast<float>(), a = imu_.accelerometer().cast<float>();
    frame_.imu.quaternion = {q[0], q[1], q[2], q[3]};
    frame_.imu.gyroscope = {w[0], w[1], w[2]};
    if (readings_ % accelerometer_readings_ == 0) frame_.imu.accelerometer = {a[0], a[1], a[2]};
    const Eigen::Vector3f rpy = rpy_zyx(imu_.quaternion()).cast<float>();
    frame_.imu.rpy = {rpy[0], rpy[1], rpy[2]};
  }
  void write_motors(const Motors& motors) {
    const Array12 q = encoders_.angles(state_.q()), dq = encoders_.velocities(state_.dq());
    const Array12 ddq = state_.ddq();
    for (int i = 0; i < kMotors; ++i) {
      MotorState motor = frame_.motorState[i];
      motor.mode = motors.law.mode[i];
      motor.q = static_cast<float>(q[i]);
      motor.dq = static_cast<float>(dq[i]);
      motor.ddq = static_cast<float>(std::trunc(ddq[i]));  // whole rad/s^2 on the wire
      motor.tauEst = static_cast<float>(wire_.torque(motors.estimated_torque[i]));
      frame_.motorState[i] = motor;
    }
  }
  /// Return roll, pitch, yaw [rad] (ZYX) of a quaternion w x y z.
  static Vector3 rpy_zyx(const Wxyz& quaternion) {
    const double w = quaternion[0], x = quaternion[1], y = quaternion[2], z = quaternion[3];
    return {std::atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)),
            std::asin(std::clamp(2 * (w * y - z * x), -1.0, 1.0)),
            std::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))};
  }

  MujocoState state_;
  WireFormat wire_;
  Imu imu_;
  std::optional<Vibration> vibration_;
  int accelerometer_readings_;
  Encoders encoders_;
  FootSensors feet_;
  Eigen::Array<int, kLegs * 3, 1> foot_forces_;
  Vector3 ground_normal_;
  LowState frame_;
  std::uint32_t tick0_;
  double rate_;  // [Hz] rate of LowState
  std::int64_t readings_ = 0;
};

}  // namespace surefoot::plant
