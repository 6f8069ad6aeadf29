// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plant/sensors.hpp"

namespace surefoot::plant {

/// Physics loop: MuJoCo's two half steps, mj_step1 and mj_step2, with motors and sensors.
///
/// The functions are called by address. So this module links no MuJoCo library, and works with the
/// library of any MuJoCo wheel. In every physics step, the motors compute their torques from the
/// present state, mj_step2 advances the state, and mj_step1 computes the positions of all bodies
/// in the new state. So after the loop all positions belong to the same instant. A fatal error of
/// MuJoCo, such as an unknown solver or lack of memory, ends the process. The models of this
/// project cause no such error.
class Physics {
 public:
  /// @param step1 address of mj_step1
  /// @param step2 address of mj_step2
  /// @param model mujoco.MjModel
  /// @param data mujoco.MjData
  /// @param state views of `data`
  Physics(std::uintptr_t step1, std::uintptr_t step2, nb::object model, nb::object data,
          MujocoState state)
      : step1_(reinterpret_cast<Step>(step1)),
        step2_(reinterpret_cast<Step>(step2)),
        model_(std::move(model)),
        data_(std::move(data)),
        m_(reinterpret_cast<const void*>(nb::cast<std::uintptr_t>(model_.attr("_address")))),
        d_(reinterpret_cast<void*>(nb::cast<std::uintptr_t>(data_.attr("_address")))),
        state_(std::move(state)) {}

  Array12 external_torque = Array12::Zero();  ///< [N.m] added to the motors' torques

  /// Advance by a number of physics steps.
  void advance(int steps, Motors& motors, Sensors& sensors) {
    Array12 dq = state_.dq();
    for (int k = 0; k < steps; ++k) {
      const Array12 applied = motors.step(state_.q(), dq) + external_torque;
      for (int i = 0; i < kMotors; ++i) state_.applied.data()[state_.motor_v[i]] = applied[i];
      step2_(m_, d_);
      step1_(m_, d_);
      dq = state_.dq();
      sensors.step(dq);
    }
  }

 private:
  using Step = void (*)(const void* model, void* data);
  Step step1_, step2_;
  nb::object model_, data_;  // owners of m_ and d_
  const void* m_;
  void* d_;
  MujocoState state_;
};

}  // namespace surefoot::plant
