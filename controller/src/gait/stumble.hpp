// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "gait/swing_contact.hpp"

namespace surefoot {

/// Swing feet that hit an obstacle. Such a foot starts a new, higher swing a little back from the
/// obstacle. This swing has a duration of its own. Real-time: yes.
///
/// Source of the reflex: Focchi et al. 2013, "Local reflex generation for obstacle negotiation in
/// quadrupedal locomotion".
class Stumble {
 public:
  explicit Stumble(const GaitSize& size) : size_(size) {}

  void start() noexcept;
  /// Judge a swing foot, and advance its lift.
  /// @param progress share of the scheduled swing that is over
  /// @return its contact confidence, but 0 if the foot has not landed
  double update(int leg, const SwingFoot& foot, double progress, double dt) noexcept;
  /// Reset the state of a foot that does not swing.
  void end(int leg) noexcept;

  const std::array<bool, kLegs>& lifting() const noexcept { return lifting_; }
  bool lifting(int leg) const noexcept { return lifting_[leg]; }
  bool begins(int leg) const noexcept { return begins_[leg]; }  ///< the lift begins in this tick
  bool any() const noexcept;                                    ///< whether any foot lifts
  double progress(int leg) const noexcept { return progress_[leg]; }  ///< of the lift, 0 .. 1
  double time_left(int leg) const noexcept;                           ///< of the lift [s]
  double time() const noexcept;                                       ///< of a whole lift [s]
  double longest_time() const noexcept;  ///< of all lifts in a swing [s]
  /// Whether the lift still goes straight up.
  bool rises(int leg) const noexcept;
  /// Point from which the lift begins: a little back from the obstacle, world frame [m].
  const Vector3& p_start(int leg) const noexcept { return p_start_[leg]; }
  double height() const noexcept;  ///< of the lift [m]

 private:
  bool may_stumble(int leg, double progress) const noexcept;

  GaitSize size_;
  std::array<bool, kLegs> lifting_{}, begins_{};
  std::array<bool, kLegs> free_{};     // the foot has left the ground in this swing
  std::array<bool, kLegs> touched_{};  // and has touched something since then
  std::array<int, kLegs> lifts_{};     // in this swing
  std::array<double, kLegs> progress_{};
  std::array<Vector3, kLegs> p_start_{};
};

}  // namespace surefoot
