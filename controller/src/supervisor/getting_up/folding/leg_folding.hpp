// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "supervisor/getting_up/folding/folding_order.hpp"
#include "supervisor/getting_up/folding/rollover_monitor.hpp"
#include "supervisor/getting_up/joint_reference.hpp"
#include "supervisor/getting_up/rise_plan.hpp"

namespace surefoot {

/// Folds the legs of a lying robot, from wherever they were measured to RisePlan::folded.
///
/// All joints go at once, by folding_target, or one diagonal pair after the other where the body
/// leans or has rolled (gain fold_wait). A joint that is held up makes its reference wait. A leg
/// that has caught on something backs out the way it came, hip outward and calf open, further from
/// try to try; every other time it lies still while the leg beside it does so, which may have
/// folded onto it. Where the body rolls over them it lets go of all legs for a second, and begins
/// again with those stretched that are drawn in; twice, then it rolls on. Real-time: yes.
class LegFolding {
 public:
  /// @param wait gain fold_wait [s]
  LegFolding(const RisePlan& plan, double wait) : plan_(plan), wait_(wait) {}
  void set_wait(double wait) noexcept { wait_ = wait; }

  /// @param measured joints, SDK motor order @param up the world's vertical, in base axes
  void start(const Vector12& measured, const Vector3& up) noexcept;
  const JointReference& step(const Vector12& measured, const Vector3& up, double dt) noexcept;
  /// Is the reference there, and the legs with it?
  bool done() const noexcept { return done_; }
  /// Legs of a side that is folded while a leg of the other has caught again and again, or is not,
  /// and the body has rolled: they weigh what all four would, were folding to end. None for two
  /// tries after side_weighed(), rolled or not.
  std::array<bool, kLegs> folded_side(const Vector12& measured) const noexcept;
  void side_weighed() noexcept { next_weighing_ = most_catches() + kCatchesBetween; }
  /// While folded legs are weighed, or press, in the place of step(): does the body roll over them?
  /// Then all are let go of, from where they are, and fold again. @param held reference of all legs
  bool detect_rollover(const JointReference& held, const Vector3& up, double dt) noexcept;
  /// Has every leg caught, is none folded, are hips and body where they were, and has it never
  /// rolled? All is too heavy for its springs.
  bool pinned(const Vector12& measured, const Vector3& up) const noexcept;
  /// Does the body roll over the legs although they were let go of?
  bool rolled_over() const noexcept { return rollover_.rolled_over(); }
  /// Has a leg caught more often than makes sense to try?
  bool stuck() const noexcept {
    return !done_ && (time_ > kTimeout || most_catches() > kMaxCatches);
  }

 private:
  static constexpr double kTimeout = 40.0;   // [s]
  static constexpr int kMaxCatches = 8;      // of one leg
  static constexpr int kMinCatches = 2;      // tries that a leg seldom needs
  static constexpr int kCatchesBetween = 2;  // from one weighing of a side to the next

  struct Leg {
    Vector3 q = Vector3::Zero();  // [rad] where it moved last, or caught
    double time = 0.0;            // [s] that it has been folding
    double still_time = 0.0;      // [s] since it moved last
    double back_out_time = 0.0;   // [s] that it still backs out for
    double rest_time = 0.0;       // [s] that it lies still for, while the leg beside it backs out
    int catches = 0;
    bool interfered = false;  // by the leg beside it, as it seems
  };

  void restart(const Vector12& measured, const Vector3& up) noexcept;
  void release_legs(const Vector12& measured, const Vector3& up, double dt) noexcept;
  int most_catches() const noexcept;  // of the leg that has caught most often
  void step_leg(int leg, const Vector12& measured, double dt) noexcept;
  FoldingOrder::Leg order_input(int leg, const Vector12& measured) const noexcept;
  bool folded(int leg, const Vector12& measured) const noexcept;
  void detect_catch(int leg, const Vector12& measured, double dt) noexcept;
  Vector3 target(int leg, const Vector12& measured) const noexcept;
  void step_joint(int joint, double wanted, double measured, double dt) noexcept;

  RisePlan plan_;
  JointReference reference_;
  std::array<Leg, kLegs> legs_;
  RolloverMonitor rollover_;
  FoldingOrder order_;
  double wait_;                          // [s]
  Vector12 q_start_ = Vector12::Zero();  // [rad] as it began ...
  double tilt_start_ = 0.0;              // [rad] ... and the body
  double time_ = 0.0;                    // [s]
  int next_weighing_ = 0;                // tries of a leg from which on a side tells again
  bool done_ = false;
};

}  // namespace surefoot
