// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/common/smoothstep.hpp"
#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Torques and damping for the twelve motors, SDK motor order.
struct MotorDemand {
  Vector12 tau = Vector12::Zero();  ///< [N.m]
  Vector12 kd = Vector12::Zero();   ///< [N.m.s/rad] Kd, with a desired velocity of 0
};

/// Source of a MotorDemand: damping only, JointImpedance or controller.
enum class TorqueSource { kDamping, kImpedance, kController };

/// Torque fade: weights that change from one torque source to another without a torque jump.
///
/// The caller computes both sources during the fade and sends
///   (1 - w) from + w to,   w = smoothstep(t / kTime)
/// for torques and damping. If the fade is reversed before its end, it continues from the present
/// weights. Real-time: yes.
class TorqueFade {
 public:
  /// [s] Duration of a fade. Chosen. If much shorter: torques change faster than TorqueRateLimiter
  /// allows (9.5 % of the limits in 2 ms). If longer: the robot sinks during the fade, and requests
  /// are rejected (kBusy) for longer.
  static constexpr double kTime = 0.25;

  /// Begin a fade to source `next`. This has no effect if `next` is already the goal.
  void start(TorqueSource next) noexcept {
    if (next == to_) return;
    // A reversed fade continues from the present weights.
    time_left_ = active() && next == from_ ? kTime - time_left_ : kTime;
    from_ = to_;
    to_ = next;
  }
  /// Change the source at once.
  void switch_to(TorqueSource next) noexcept {
    from_ = to_ = next;
    time_left_ = 0.0;
  }
  void advance(double dt) noexcept { time_left_ = std::max(time_left_ - dt, 0.0); }
  bool active() const noexcept { return time_left_ > 0.0; }
  /// Return whether `source` must be computed in this tick.
  bool uses(TorqueSource source) const noexcept {
    return to_ == source || (active() && from_ == source);
  }
  TorqueSource from() const noexcept { return from_; }
  TorqueSource to() const noexcept { return to_; }
  /// Return the weight w of to(), 0 .. 1. The weight of from() is 1 - w.
  double weight() const noexcept { return smoothstep(1.0 - time_left_ / kTime); }

 private:
  TorqueSource from_ = TorqueSource::kDamping, to_ = TorqueSource::kDamping;
  double time_left_ = 0.0;  // [s] time until the end of the fade
};

}  // namespace surefoot
