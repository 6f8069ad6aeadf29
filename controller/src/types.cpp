// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/types.hpp"

namespace surefoot {

const char* to_string(Status status) noexcept {
  switch (status) {
    case Status::kOk:
      return "ok";
    case Status::kWaiting:
      return "waiting";
    case Status::kNonFinite:
      return "non_finite";
    case Status::kWrongSize:
      return "wrong_size";
    case Status::kBadQuaternion:
      return "bad_quaternion";
    case Status::kStaleTick:
      return "stale_tick";
    case Status::kMaxIterations:
      return "max_iterations";
    case Status::kInfeasible:
      return "infeasible";
    case Status::kSingular:
      return "singular";
    case Status::kDamping:
      return "damping";
  }
  return "unknown";
}

}  // namespace surefoot
