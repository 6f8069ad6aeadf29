// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Brings the body over three feet once a leg is given up. Real-time: yes.
class ThreeLegStance {
 public:
  static constexpr int kNone = -1;

  void give_up_leg(int leg) noexcept { lost_leg_ = leg; }
  void reset() noexcept {
    lost_leg_ = kNone;
    com_offset_.setZero();
  }
  int lost_leg() const noexcept { return lost_leg_; }  ///< the leg, or kNone

  /// @param nominal_feet of the feet and @param p_com wanted over all of them, support axes
  void update(const FeetMatrix& nominal_feet, const Vector3& p_com, double dt) noexcept;

  /// [m] by which the centre of mass is to go from there, support axes.
  const Vector3& com_offset() const noexcept { return com_offset_; }

 private:
  int lost_leg_ = kNone;
  Vector3 com_offset_ = Vector3::Zero();
};

}  // namespace surefoot
