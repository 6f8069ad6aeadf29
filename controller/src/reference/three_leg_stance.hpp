// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Shifts the centre of mass into the support triangle of three feet after a leg is lost.
/// Real-time: yes.
class ThreeLegStance {
 public:
  static constexpr int kNone = -1;  ///< value of lost_leg() if no leg is lost

  /// Declare a leg lost until reset().
  void declare_leg_lost(int leg) noexcept { lost_leg_ = leg; }
  void reset() noexcept {
    lost_leg_ = kNone;
    com_offset_.setZero();
  }
  int lost_leg() const noexcept { return lost_leg_; }  ///< 0 .. 3; kNone: no leg is lost

  /// Update the shift by one tick. Without a lost leg nothing changes.
  /// @param nominal_feet nominal foot positions, support frame [m]
  /// @param p_com desired centre of mass of the four-legged stance, support frame [m]
  void update(const FeetMatrix& nominal_feet, const Vector3& p_com, double dt) noexcept;

  /// Shift of the desired centre of mass, support axes [m].
  const Vector3& com_offset() const noexcept { return com_offset_; }

 private:
  int lost_leg_ = kNone;
  Vector3 com_offset_ = Vector3::Zero();
};

}  // namespace surefoot
