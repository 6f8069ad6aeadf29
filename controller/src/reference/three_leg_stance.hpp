// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Shifts the centre of mass into the support triangle of three feet after a leg is lost.
/// Real-time: yes.
class ThreeLegStance {
 public:
  void reset() noexcept { com_offset_.setZero(); }

  /// Update the shift by one tick. Without a lost leg nothing changes.
  /// @param lost_leg 0 .. 3, or -1 for none
  /// @param nominal_feet nominal foot positions, support frame [m]
  /// @param p_com desired centre of mass of the four-legged stance, support frame [m]
  void update(int lost_leg, const FeetMatrix& nominal_feet, const Vector3& p_com,
              double dt) noexcept;

  /// Shift of the desired centre of mass, support axes [m].
  const Vector3& com_offset() const noexcept { return com_offset_; }

 private:
  Vector3 com_offset_ = Vector3::Zero();
};

}  // namespace surefoot
