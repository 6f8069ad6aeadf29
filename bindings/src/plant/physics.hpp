// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plant/sensors.hpp"

namespace surefoot::plant {

/// MuJoCo's two half steps, called by address: the wheel's own library, whatever its version, and
/// nothing to link to. What MuJoCo calls an error (a solver that does not exist, memory that is
/// out) ends the process, as in any C program that uses it: the models made here give it no cause.
///
/// mj_step2 uses what mj_step1 has computed of the same instant, so torque laws see the present
/// state, and after the loop every position belongs to the present too.
class Physics {
 public:
  Physics(std::uintptr_t step1, std::uintptr_t step2, nb::object model, nb::object data,
          MujocoState state)
      : step1_(reinterpret_cast<Step>(step1)),
        step2_(reinterpret_cast<Step>(step2)),
        model_(std::move(model)),
        data_(std::move(data)),
        m_(reinterpret_cast<const void*>(nb::cast<std::uintptr_t>(model_.attr("_address")))),
        d_(reinterpret_cast<void*>(nb::cast<std::uintptr_t>(data_.attr("_address")))),
        state_(std::move(state)) {}

  Array12 external_torque = Array12::Zero();  ///< [N.m] that hands add to the motors' torques

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
  nb::object model_, data_;  // kept alive
  const void* m_;
  void* d_;
  MujocoState state_;
};

}  // namespace surefoot::plant
