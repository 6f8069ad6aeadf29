// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "surefoot/planner.hpp"

namespace surefoot {

/// A planner that keeps the pose of its first tick. Then it calls `change`, which the test sets.
class LambdaPlanner : public Planner {
 public:
  using Change = std::function<bool(const PlannerInput&, Reference&)>;
  bool plan(const PlannerInput& input, Reference& reference) noexcept override {
    ++calls;
    if (calls == 1) {
      reference.p_com = input.p_com;
      reference.R_world_base = Quaternion(input.R_world_base);
      for (int leg = 0; leg < kLegs; ++leg) reference.feet[leg].p_world = input.p_feet.col(leg);
    }
    return !change || change(input, reference);
  }
  void reset() noexcept override { calls = 0; }

  long calls = 0;  ///< since reset()
  Change change;
};

}  // namespace surefoot
