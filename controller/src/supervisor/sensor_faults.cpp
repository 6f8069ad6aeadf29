// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/sensor_faults.hpp"

namespace surefoot {

namespace {

constexpr double kGyroscopeTime = 0.05;  // [s] legs tell the attitude rate for so long
constexpr double kSensorTime = 0.02;     // [s] of any other sensor
constexpr double kSlipTime = 0.02;       // [s]
constexpr double kLiftedTime = 0.05;     // [s]
constexpr double kPayloadTime = 1.0;     // [s] pushes are no payloads
constexpr double kSlips = 0.5;           // how surely

bool bad(Verdict verdict) noexcept {
  return verdict != Verdict::kGood && verdict != Verdict::kUnjudged;
}

bool foot_force_bad(const EstimatorReport& report) noexcept {
  for (const ContactSource source : {ContactSource::kFootForceEst, ContactSource::kFootForce}) {
    const auto& verdicts = report.contact_sources[static_cast<int>(source)];
    int zero = 0, wrong = 0;
    for (const Verdict verdict : verdicts) {
      zero += verdict == Verdict::kZero;
      wrong += bad(verdict);
    }
    // A source that has never said anything is not there, on most robots; that is no fault.
    if (wrong > 0 && zero < kLegs) return true;
  }
  return false;
}

}  // namespace

void SensorFaults::update(const EstimatorReport& report, const RobotState& state, double dt,
                          FaultLog& log) noexcept {
  log.set(FaultId::kGyroscope, gyroscope_.update(bad(report.gyroscope), dt, kGyroscopeTime));
  log.set(FaultId::kAccelerometer,
          accelerometer_.update(bad(report.accelerometer), dt, kSensorTime));
  log.set(FaultId::kQuaternion, quaternion_.update(bad(report.quaternion), dt, kSensorTime));
  log.set(FaultId::kFootForce, foot_force_bad(report));
  log.set(FaultId::kSlip, slip_.update(report.slip.maxCoeff() > kSlips, dt, kSlipTime));
  log.set(FaultId::kLifted, lifted_.update(state.contact.maxCoeff() < 0.5, dt, kLiftedTime));
  log.set(FaultId::kPayload, payload_.update(report.payload > payload_limit_, dt, kPayloadTime));
}

void SensorFaults::reset(FaultLog& log) noexcept {
  *this = SensorFaults(payload_limit_);
  for (const FaultId id :
       {FaultId::kGyroscope, FaultId::kAccelerometer, FaultId::kQuaternion, FaultId::kFootForce,
        FaultId::kSlip, FaultId::kLifted, FaultId::kPayload}) {
    log.set(id, false);
  }
}

}  // namespace surefoot
