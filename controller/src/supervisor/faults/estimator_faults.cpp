// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/faults/estimator_faults.hpp"

namespace surefoot {

namespace {

// [s] Times for which a finding must last before it is a fault. Chosen by hand. Each must be
// shorter than the detection time of the fault in fault_table(), given in brackets.
constexpr double kGyroscopeTime = 0.05;  // [1 s] the estimator uses rates from the legs meanwhile
constexpr double kSensorTime = 0.02;     // [0.1 s and more] accelerometer, quaternion
constexpr double kSlipTime = 0.02;       // [0.1 s] longer than single wrong ticks
constexpr double kLiftedTime = 0.05;     // [0.1 s] longer than impacts that unload all feet
// [0.25 s] While feet step: longer than the flight of a fast trot, 80 ms at h = 0.3 m, and that of
// a robot which falls off a step. The same as kAirborneTime of WalkPlanner.
constexpr double kSteppingLiftedTime = 0.2;
constexpr double kPayloadTime = 1.0;  // [2 s] longer than pushes (0.5 s in the full scorecard)
// EstimatorReport::slip (0 .. 1) above which a foot slips. Chosen.
constexpr double kMinSlip = 0.5;

bool is_bad(SensorVerdict verdict) noexcept {
  return verdict != SensorVerdict::kGood && verdict != SensorVerdict::kUnjudged;
}

bool is_foot_force_bad(const EstimatorReport& report) noexcept {
  for (const ContactSource source : {ContactSource::kFootForceEst, ContactSource::kFootForce}) {
    const auto& verdicts = report.contact_sources[static_cast<int>(source)];
    int zero = 0, wrong = 0;
    for (const SensorVerdict verdict : verdicts) {
      zero += verdict == SensorVerdict::kZero;
      wrong += is_bad(verdict);
    }
    // Most robots have only one of these sources. A missing source reads zero on all feet, which is
    // no fault.
    if (wrong > 0 && zero < kLegs) return true;
  }
  return false;
}

}  // namespace

void EstimatorFaults::update(const EstimatorReport& report, const RobotState& state, bool stepping,
                             double dt, FaultLog& log) noexcept {
  gyroscope_bad_ = gyroscope_.update(is_bad(report.gyroscope), dt, kGyroscopeTime);
  accelerometer_bad_ = accelerometer_.update(is_bad(report.accelerometer), dt, kSensorTime);
  quaternion_bad_ = quaternion_.update(is_bad(report.quaternion), dt, kSensorTime);
  overloaded_ = payload_.update(report.payload > payload_limit_, dt, kPayloadTime);
  log.set(FaultId::kFootForce, is_foot_force_bad(report));
  log.set(FaultId::kSlip, slip_.update(report.slip.maxCoeff() > kMinSlip, dt, kSlipTime));
  log.set(FaultId::kLifted, lifted_.update(state.contact.maxCoeff() < 0.5, dt,
                                           stepping ? kSteppingLiftedTime : kLiftedTime));
  log.set(FaultId::kPayload, overloaded_);
}

void EstimatorFaults::reset(bool sitting, FaultLog& log) noexcept {
  const bool keep_gyroscope_fault = sitting && gyroscope_bad_,
             keep_overload_fault = sitting && overloaded_;
  *this = EstimatorFaults(payload_limit_);
  gyroscope_bad_ = keep_gyroscope_fault;
  overloaded_ = keep_overload_fault;
  for (const FaultId id : {FaultId::kFootForce, FaultId::kSlip, FaultId::kLifted}) {
    log.set(id, false);
  }
  log.set(FaultId::kPayload, overloaded_);
}

}  // namespace surefoot
