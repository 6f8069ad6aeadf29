// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Brings the body over three feet once a leg is given up. Real-time: yes.
class ThreeFeet {
 public:
  static constexpr int kNone = -1;

  void give_up(int leg) noexcept { lost_ = leg; }
  void reset() noexcept {
    lost_ = kNone;
    lean_.setZero();
  }
  int lost() const noexcept { return lost_; }  ///< the leg, or kNone

  /// @param places of the feet and @param p_com wanted over all of them, support axes
  void step(const FeetMatrix& places, const Vector3& p_com, double dt) noexcept;

  /// [m] by which the centre of mass is to go from there, support axes.
  const Vector3& lean() const noexcept { return lean_; }

 private:
  int lost_ = kNone;
  Vector3 lean_ = Vector3::Zero();
};

}  // namespace surefoot
