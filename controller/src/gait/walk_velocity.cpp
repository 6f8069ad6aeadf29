// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/walk_velocity.hpp"

namespace surefoot {

const char* to_string(WalkLimit limit) noexcept {
  switch (limit) {
    case WalkLimit::kNone:
      return "none";
    case WalkLimit::kForward:
      return "forward";
    case WalkLimit::kSideways:
      return "sideways";
    case WalkLimit::kTurn:
      return "turn";
    case WalkLimit::kCombination:
      return "combination";
    case WalkLimit::kPower:
      return "power";
    case WalkLimit::kNotFinite:
      return "not_finite";
  }
  return "unknown";
}

const char* to_string(Gait gait) noexcept {
  switch (gait) {
    case Gait::kAuto:
      return "auto";
    case Gait::kTrot:
      return "trot";
    case Gait::kWalk:
      return "walk";
  }
  return "unknown";
}

}  // namespace surefoot
