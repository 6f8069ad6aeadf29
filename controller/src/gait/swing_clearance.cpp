// SPDX-License-Identifier: BSD-3-Clause
#include "gait/swing_clearance.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

// [h] Extra height after a stumble: 6 cm at h = 0.3 m, beside the 4.5 cm of swing_height. Chosen:
// clears a step of 8 cm with a margin of a foot radius.
constexpr double kMaxExtra = 0.2;
// [h] Step below which the ground counts as even: 3 cm at h = 0.3 m. Measured: soft soles and the
// estimate of the height make up to 0.06 h on flat ground.
constexpr double kEven = 0.1;
// [h] Distance after which the extra height ends. Chosen: the rear feet then have passed the place
// where the front feet stumbled (1.4 h to 1.6 h behind).
constexpr double kDistance = 3.0;

}  // namespace

void SwingClearance::stumble() noexcept { raise(kMaxExtra * size_.height); }

void SwingClearance::land(double step) noexcept {
  if (std::abs(step) > kEven * size_.height) {
    raise(std::min(std::abs(step), kMaxExtra * size_.height));
  }
}

void SwingClearance::raise(double extra) noexcept {
  if (extra < extra_) return;
  extra_ = extra;
  travelled_ = 0.0;
}

void SwingClearance::advance(double speed, double dt) noexcept {
  travelled_ += speed * dt;
  if (travelled_ > kDistance * size_.height) extra_ = 0.0;
}

}  // namespace surefoot
