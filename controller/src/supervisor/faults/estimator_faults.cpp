// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/faults/estimator_faults.hpp"

namespace surefoot {

namespace {

// Minimum times of a finding, chosen by hand. Above: the detection times of fault_table().
constexpr double kGyroscopeTime = 0.05;  // [s] of 1 s; the legs give the attitude rate meanwhile
constexpr double kSensorTime = 0.02;     // [s] of 0.1 s and more, for every other sensor
constexpr double kSlipTime = 0.02;       // [s] of 0.1 s; below: single wrong ticks
constexpr double kLiftedTime = 0.05;     // [s] of 0.1 s; below: impacts that unload all feet
constexpr double kPayloadTime = 1.0;     // [s] of 2 s; below: pushes (0.5 s in the full scorecard)
constexpr double kMinSlip = 0.5;         // confidence of slip

bool bad(SensorVerdict verdict) noexcept {
  return verdict != SensorVerdict::kGood && verdict != SensorVerdict::kUnjudged;
}

bool foot_force_bad(const EstimatorReport& report) noexcept {
  for (const ContactSource source : {ContactSource::kFootForceEst, ContactSource::kFootForce}) {
    const auto& verdicts = report.contact_sources[static_cast<int>(source)];
    int zero = 0, wrong = 0;
    for (const SensorVerdict verdict : verdicts) {
      zero += verdict == SensorVerdict::kZero;
      wrong += bad(verdict);
    }
    // A source that reads zero on all feet does not exist on this robot, as on most: no fault.
    if (wrong > 0 && zero < kLegs) return true;
  }
  return false;
}

}  // namespace

void EstimatorFaults::update(const EstimatorReport& report, const RobotState& state, double dt,
                             FaultLog& log) noexcept {
  gyroscope_bad_ = gyroscope_.update(bad(report.gyroscope), dt, kGyroscopeTime);
  accelerometer_bad_ = accelerometer_.update(bad(report.accelerometer), dt, kSensorTime);
  quaternion_bad_ = quaternion_.update(bad(report.quaternion), dt, kSensorTime);
  overloaded_ = payload_.update(report.payload > payload_limit_, dt, kPayloadTime);
  log.set(FaultId::kFootForce, foot_force_bad(report));
  log.set(FaultId::kSlip, slip_.update(report.slip.maxCoeff() > kMinSlip, dt, kSlipTime));
  log.set(FaultId::kLifted, lifted_.update(state.contact.maxCoeff() < 0.5, dt, kLiftedTime));
  log.set(FaultId::kPayload, overloaded_);
}

void EstimatorFaults::reset(bool sitting, FaultLog& log) noexcept {
  const bool gyroscope_held = sitting && gyroscope_bad_, overload_held = sitting && overloaded_;
  *this = EstimatorFaults(payload_limit_);
  gyroscope_bad_ = gyroscope_held;
  overloaded_ = overload_held;
  for (const FaultId id : {FaultId::kFootForce, FaultId::kSlip, FaultId::kLifted}) {
    log.set(id, false);
  }
  log.set(FaultId::kPayload, overloaded_);
}

}  // namespace surefoot
