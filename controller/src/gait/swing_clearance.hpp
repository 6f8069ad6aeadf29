// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/gait_size.hpp"

namespace surefoot {

/// Additional height of the swings on uneven ground. A foot that hit an obstacle, or landed above
/// or below the ground plane, raises all swings until the robot has passed that place. Real-time:
/// yes.
class SwingClearance {
 public:
  explicit SwingClearance(const GaitSize& size) : size_(size) {}

  void start() noexcept { extra_ = travelled_ = 0.0; }
  void stumble() noexcept;
  /// @param step height of the foot above the ground plane when it lands [m]
  void land(double step) noexcept;
  /// @param speed of the fastest hip [m/s]
  void advance(double speed, double dt) noexcept;

  double extra() const noexcept { return extra_; }  ///< height beyond the gain swing_height [m]

 private:
  void raise(double extra) noexcept;

  GaitSize size_;
  double extra_ = 0.0;      // [m]
  double travelled_ = 0.0;  // [m] since extra_ was raised
};

}  // namespace surefoot
