// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/common/smoothstep.hpp"
#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// What the twelve motors are told: torques, and damping of their own.
struct MotorDemand {
  Vector12 tau = Vector12::Zero();  ///< [N.m]
  Vector12 kd = Vector12::Zero();   ///< [N.m.s/rad] with dq = 0
};

/// Who decides it.
enum class TorqueSource { kDamping, kImpedance, kController };

/// Goes over from one source to another without a jump, while both are computed. Real-time: yes.
class TorqueFade {
 public:
  static constexpr double kTime = 0.25;  // [s]

  void start(TorqueSource next) noexcept {
    if (next == to_) return;
    // Back to where it came from: from the share that it still has.
    time_left_ = active() && next == from_ ? kTime - time_left_ : kTime;
    from_ = to_;
    to_ = next;
  }
  void switch_to(TorqueSource next) noexcept {
    from_ = to_ = next;
    time_left_ = 0.0;
  }
  void advance(double dt) noexcept { time_left_ = std::max(time_left_ - dt, 0.0); }
  bool active() const noexcept { return time_left_ > 0.0; }
  bool uses(TorqueSource source) const noexcept {
    return to_ == source || (active() && from_ == source);
  }
  TorqueSource from() const noexcept { return from_; }
  TorqueSource to() const noexcept { return to_; }
  double weight() const noexcept { return smoothstep(1.0 - time_left_ / kTime); }  ///< of to()

 private:
  TorqueSource from_ = TorqueSource::kDamping, to_ = TorqueSource::kDamping;
  double time_left_ = 0.0;  // [s]
};

}  // namespace surefoot
