// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/smooth.hpp"
#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// What the twelve motors are told: torques, and damping of their own.
struct Drive {
  Vector12 tau = Vector12::Zero();  ///< [N.m]
  Vector12 kd = Vector12::Zero();   ///< [N.m.s/rad] with dq = 0
};

/// Who decides it.
enum class Source { kDamping, kSprings, kProgram };

/// Goes over from one source to another without a jump, while both are computed. Real-time: yes.
class TorqueFade {
 public:
  static constexpr double kTime = 0.25;  // [s]

  void to(Source next) noexcept {
    if (next == to_) return;
    // Back to where it came from: from the share that it still has.
    left_ = moving() && next == from_ ? kTime - left_ : kTime;
    from_ = to_;
    to_ = next;
  }
  void jump(Source next) noexcept {
    from_ = to_ = next;
    left_ = 0.0;
  }
  void advance(double dt) noexcept { left_ = std::max(left_ - dt, 0.0); }
  bool moving() const noexcept { return left_ > 0.0; }
  bool needs(Source source) const noexcept {
    return to_ == source || (moving() && from_ == source);
  }
  Source from() const noexcept { return from_; }
  Source to() const noexcept { return to_; }
  double weight() const noexcept { return smooth(1.0 - left_ / kTime); }  ///< of to()

 private:
  Source from_ = Source::kDamping, to_ = Source::kDamping;
  double left_ = 0.0;  // [s]
};

}  // namespace surefoot
