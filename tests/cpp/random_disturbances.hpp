// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "robot_states.hpp"
#include "surefoot/body_reference.hpp"

/// Samples of a robot with pushes, sensor faults, lifted feet and tick errors, alone and combined.
class RandomDisturbances {
 public:
  explicit RandomDisturbances(const surefoot::Robot& robot) : rest_(resting_sample(robot, 0)) {}

  const surefoot::LowState& report(std::uint32_t tick) {
    report_ = rest_;
    report_.tick = 2 * tick;
    const bool pushed = tick % 500 < 50;
    const float wave = std::sin(0.05F * static_cast<float>(tick));
    report_.imu.gyroscope[0] = (pushed ? 2.0F : 0.1F) * wave;
    report_.imu.accelerometer[1] = (pushed ? 8.0F : 0.5F) * number();
    for (int i = 0; i < surefoot::kMotors; ++i) {
      report_.motorState[i].dq = (pushed ? 6.0F : 0.3F) * number();
      // The estimator ignores constant torques; for a fifth of the time these are constant.
      if (tick % 5000 < 4000) report_.motorState[i].tauEst += 0.05F * wave;
      report_.motorState[i].q += 0.3F * wave * (tick % 3000 < 1500 ? 0.1F : 1.0F);
    }
    // footForceEst is zero for a quarter of the time; the feet lift one after the other.
    for (int leg = 0; leg < surefoot::kLegs; ++leg) {
      const bool lifted = (tick / 150) % 6 == static_cast<std::uint32_t>(leg);
      report_.footForceEst[leg] =
          tick % 4000 < 1000 ? std::int16_t{0} : static_cast<std::int16_t>(lifted ? 0 : 30);
    }
    // A knee is nearly straight at times, so that kAuto changes the form.
    if (tick % 700 > 650) report_.motorState[surefoot::FL_2].q = -0.02F;
    add_fault(tick);
    return report_;
  }

  /// Return a requested body pose, mostly beyond what the robot can reach.
  surefoot::BodyReference reference() {
    const auto far = [this](double size) { return size * static_cast<double>(number()); };
    return {far(0.15), far(0.15), far(0.2), far(0.5), far(0.5), far(0.8)};
  }

 private:
  float number() { return uniform_(generator_); }
  void add_fault(std::uint32_t tick) {
    if (tick % 1000 == 0) report_.tick -= 2;
    if (tick % 1300 == 0) report_.imu.gyroscope[1] = std::nanf("");
    if (tick % 1700 == 0) report_.motorState[4].q = 900.0F;
    if (tick % 1900 == 0) report_.imu.quaternion = {};
    if (tick % 5000 > 4980) report_.imu.accelerometer[0] = std::nanf("");  // until it damps
  }

  surefoot::LowState rest_, report_;
  std::mt19937 generator_{1};
  std::uniform_real_distribution<float> uniform_{-1.0F, 1.0F};
};
