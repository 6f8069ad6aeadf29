// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/rise_plan.hpp"

namespace surefoot {

/// Where the joints are to be, and how fast they go there; SDK motor order.
struct JointReference {
  Vector12 q = Vector12::Zero();   ///< [rad]
  Vector12 dq = Vector12::Zero();  ///< [rad/s]
};

/// Folds the legs of a lying robot, from wherever they were measured to RisePlan::folded.
///
/// All joints go at once. While a knee is below its hip that hip is turned outward, so that the leg
/// sweeps beside the body; once the knee is up the hip goes straight, or the knees of a pair would
/// meet over the back. A knee that leans over the body is turned back until its hip is straight:
/// upright it would wedge itself against the body's edge. A joint that is held up makes its
/// reference wait. Real-time: yes.
class LegFolding {
 public:
  explicit LegFolding(const RisePlan& plan) : plan_(plan) {}

  void start(const Vector12& measured) noexcept;
  const JointReference& step(const Vector12& measured, double dt) noexcept;
  /// Is the reference there, and the legs with it?
  bool done() const noexcept { return done_; }
  bool stuck() const noexcept { return !done_ && time_ > kPatience; }

 private:
  static constexpr double kPatience = 10.0;  // [s]
  Vector12 target(const Vector12& measured) const noexcept;

  RisePlan plan_;
  JointReference reference_;
  double time_ = 0.0;  // [s]
  bool done_ = false;
};

}  // namespace surefoot
