// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "supervisor/folding_turns.hpp"
#include "supervisor/rise_plan.hpp"
#include "supervisor/roll_watch.hpp"

namespace surefoot {

/// Where the joints are to be, and how fast they go there; SDK motor order.
struct JointReference {
  Vector12 q = Vector12::Zero();   ///< [rad]
  Vector12 dq = Vector12::Zero();  ///< [rad/s]
};

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
  void side_weighed() noexcept { next_weighing_ = most_tries() + kTriesBetween; }
  /// While folded legs are weighed, or press, in the place of step(): does the body roll over them?
  /// Then all are let go of, from where they are, and fold again. @param at reference of all legs
  bool rolls(const JointReference& at, const Vector3& up, double dt) noexcept;
  /// Has every leg caught, is none folded, are hips and body where they were, and has it never
  /// rolled? All is too heavy for its springs.
  bool pinned(const Vector12& measured, const Vector3& up) const noexcept;
  /// Does the body roll over the legs although they were let go of?
  bool rolls_on() const noexcept { return roll_.rolls_on(); }
  /// Has a leg caught more often than makes sense to try?
  bool stuck() const noexcept { return !done_ && (time_ > kPatience || most_tries() > kTries); }

 private:
  static constexpr double kPatience = 40.0;  // [s]
  static constexpr int kTries = 8;           // of one leg
  static constexpr int kCaught = 2;          // tries that a leg seldom needs
  static constexpr int kTriesBetween = 2;    // from one weighing of a side to the next

  struct Leg {
    Vector3 q = Vector3::Zero();  // [rad] where it moved last, or caught
    double time = 0.0;            // [s] that it has been folding
    double still = 0.0;           // [s] since it moved last
    double back = 0.0;            // [s] that it still backs out for
    double rest = 0.0;            // [s] that it lies still for, while the leg beside it backs out
    int tries = 0;
    bool wedged = false;  // by the leg beside it, as it seems
  };

  void begin(const Vector12& measured, const Vector3& up) noexcept;
  void let_go(const Vector12& measured, const Vector3& up, double dt) noexcept;
  int most_tries() const noexcept;  // of the leg that has caught most often
  void move(int leg, const Vector12& measured, double dt) noexcept;
  FoldingTurns::Leg turn_of(int leg, const Vector12& measured) const noexcept;
  bool folded(int leg, const Vector12& measured) const noexcept;
  void watch(int leg, const Vector12& measured, double dt) noexcept;
  Vector3 target(int leg, const Vector12& measured) const noexcept;
  void follow(int joint, double wanted, double measured, double dt) noexcept;

  RisePlan plan_;
  JointReference reference_;
  std::array<Leg, kLegs> legs_;
  RollWatch roll_;
  FoldingTurns turns_;
  double wait_;                        // [s]
  Vector12 first_ = Vector12::Zero();  // [rad] as it began ...
  double lean_ = 0.0;                  // [rad] ... and the body
  double time_ = 0.0;                  // [s]
  int next_weighing_ = 0;              // tries of a leg from which on a side tells again
  bool done_ = false;
};

}  // namespace surefoot
