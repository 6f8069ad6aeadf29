// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "supervisor/getting_up/folding/folding_order.hpp"
#include "supervisor/getting_up/folding/rollover_monitor.hpp"
#include "supervisor/getting_up/joint_reference.hpp"
#include "supervisor/getting_up/rise_plan.hpp"

namespace surefoot {

/// Folding: moves the legs of a lying robot from any measured pose to RisePlan::folded.
///
/// Every joint reference moves towards folding_target(), and waits if the measured joint lags
/// behind. All legs move at once. Exception: if the body leans or has rolled, one diagonal pair
/// waits for at most the gain fold_wait (FoldingOrder).
///
/// Catching: a leg that does not move for 1 s (kCatchTime) before it is folded has caught on
/// something. The leg then backs out, with the hip outward and the calf open, and further with each
/// catch. On every second catch the leg rests, and its neighbour on the same side backs out
/// instead, because the neighbour may have folded onto the leg. If a leg catches more than
/// kMaxCatches times, the folding is stuck().
///
/// Rolling: if the body rolls over its legs, all legs are released for 1 s and then fold again;
/// drawn-in legs stretch first. If the body keeps rolling, it has rolled_over() (RolloverMonitor).
/// Real-time: yes.
class LegFolding {
 public:
  /// @param wait gain fold_wait [s]
  LegFolding(const RisePlan& plan, double wait) : plan_(plan), wait_(wait) {}
  void set_wait(double wait) noexcept { wait_ = wait; }

  /// Start folding.
  /// @param measured joint angles, SDK motor order [rad]
  /// @param up the world's vertical in base axes, unit length
  void start(const Vector12& measured, const Vector3& up) noexcept;
  /// Advance by dt [s] and return the joint reference.
  const JointReference& step(const Vector12& measured, const Vector3& up, double dt) noexcept;
  /// Return whether all joint references and legs have reached RisePlan::folded.
  bool done() const noexcept { return done_; }
  /// Return the folded legs of one side if LegWeightCheck should weigh this side alone, otherwise
  /// no leg (all false). A side is weighed alone if a leg of the other side has caught kMinCatches
  /// times, or if the body has rolled, because the folding of all four legs may then never end.
  /// After side_weighed(), no side is returned until the largest number of catches of any leg has
  /// grown by kCatchesBetween.
  std::array<bool, kLegs> folded_side(const Vector12& measured) const noexcept;
  /// Record that a side has been weighed.
  void side_weighed() noexcept { next_weighing_ = max_catches() + kCatchesBetween; }
  /// Return whether the body rolls over its folded legs. Call this instead of step() in the stages
  /// kWeigh and kPress of the rise. If the result is true, continue with step(), which releases the
  /// legs and folds them again.
  /// @param held present joint reference of all legs; folding starts again from this reference
  bool detect_rollover(const JointReference& held, const Vector3& up, double dt) noexcept;
  /// Return whether no leg can move: all legs have caught, no leg is folded, hips and tilt have
  /// hardly changed, and the body has not rolled. Then a person or an obstacle holds the legs, or
  /// the legs are too heavy for JointImpedance.
  bool pinned(const Vector12& measured, const Vector3& up) const noexcept;
  /// Return whether the body has rolled over although its legs were released, see RolloverMonitor.
  bool rolled_over() const noexcept { return rollover_.rolled_over(); }
  /// Return whether folding is not done, and has taken longer than kTimeout or a leg has caught
  /// more than kMaxCatches times.
  bool stuck() const noexcept {
    return !done_ && (time_ > kTimeout || max_catches() > kMaxCatches);
  }

 private:
  // The limits are chosen by hand, above the duration of get-ups: median 7 to 10 s, at most 19 s
  // (benchmarks/get_up.py). Test: folding_stops_after_several_retries_of_a_caught_leg (15 to 45 s).
  //
  // [s] Longest time of folding since the start or the last release.
  static constexpr double kTimeout = 40.0;
  // Largest number of catches of one leg. Eight catches take 8 (kCatchTime + kBackOutTime) = 20 s.
  static constexpr int kMaxCatches = 8;
  // Number of catches of one leg after which the other side may be weighed alone. A healthy leg
  // seldom reaches it.
  static constexpr int kMinCatches = 2;
  // Number of further catches after which a side is weighed again.
  static constexpr int kCatchesBetween = 2;

  struct Leg {
    Vector3 q = Vector3::Zero();  // [rad] joint angles at the last motion or catch of the leg
    double time = 0.0;            // [s] time for which the leg has been folding
    double still_time = 0.0;      // [s] time since the leg last moved
    double back_out_time = 0.0;   // [s] time until the leg stops backing out
    // [s] Time until the leg stops resting; its neighbour backs out meanwhile.
    double rest_time = 0.0;
    int catches = 0;
    bool interfered = false;  // true if the leg and its neighbour may block each other
  };

  void restart(const Vector12& measured, const Vector3& up) noexcept;
  void relax_legs(const Vector12& measured, const Vector3& up, double dt) noexcept;
  int max_catches() const noexcept;  // largest number of catches of any leg
  void step_leg(int leg, const Vector12& measured, double dt) noexcept;
  FoldingOrder::Leg order_input(int leg, const Vector12& measured) const noexcept;
  bool folded(int leg, const Vector12& measured) const noexcept;
  void detect_catch(int leg, const Vector12& measured, double dt) noexcept;
  Vector3 target(int leg, const Vector12& measured) const noexcept;
  void step_joint(int joint, double desired, double measured, double dt) noexcept;

  RisePlan plan_;
  JointReference reference_;
  std::array<Leg, kLegs> legs_;
  RolloverMonitor rollover_;
  FoldingOrder order_;
  double wait_;                          // [s] gain fold_wait
  Vector12 q_start_ = Vector12::Zero();  // [rad] joint angles at the start
  double tilt_start_ = 0.0;              // [rad] tilt of the body at the start
  double time_ = 0.0;                    // [s] time since the start or the last release
  int next_weighing_ = 0;                // number of catches from which a side is weighed again
  bool done_ = false;
};

}  // namespace surefoot
