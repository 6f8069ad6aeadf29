// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/estimator_report.hpp"

namespace surefoot {

const char* to_string(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::kGood:
      return "good";
    case Verdict::kUnjudged:
      return "unjudged";
    case Verdict::kZero:
      return "zero";
    case Verdict::kConstant:
      return "constant";
    case Verdict::kSaturated:
      return "saturated";
    case Verdict::kDisagrees:
      return "disagrees";
    case Verdict::kImplausible:
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
    case ContactSource::kNoSlip:
      return "no slip";
  }
  return "unknown";
}

}  // namespace surefoot
