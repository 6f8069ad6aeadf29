// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/estimator_report.hpp"

namespace surefoot {

const char* to_string(SensorVerdict verdict) noexcept {
  switch (verdict) {
    case SensorVerdict::kGood:
      return "good";
    case SensorVerdict::kUnjudged:
      return "unjudged";
    case SensorVerdict::kZero:
      return "zero";
    case SensorVerdict::kConstant:
      return "constant";
    case SensorVerdict::kSaturated:
      return "saturated";
    case SensorVerdict::kDisagrees:
      return "disagrees";
    case SensorVerdict::kImplausible:
      return "implausible";
  }
  return "unknown";
}

const char* to_string(ContactSource source) noexcept {
  switch (source) {
    case ContactSource::kFootForceEst:
      return "footForceEst";
    case ContactSource::kFootForce:
      return "footForce";
    case ContactSource::kTauEst:
      return "tauEst";
    case ContactSource::kFootMotion:
      return "no slip";
  }
  return "unknown";
}

}  // namespace surefoot
