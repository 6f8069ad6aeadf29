// SPDX-License-Identifier: BSD-3-Clause
// Fault detection on a usable sample, and the reactions.
#include <cmath>

#include "supervisor/common/tilt.hpp"
#include "supervisor/supervisor_impl.hpp"

namespace surefoot {

namespace {

// Chosen by hand.
// [rad] 40 degrees: tilt above which a rising or sitting robot has fallen. Must exceed the tilt on
// slopes of 8 degrees (benchmarks/false_trips.py). Must be below the 60 degrees of the row
// body_tilt.
constexpr double kFallTilt = 0.7;
// [rad] Tilt above which a lying body has fallen. Must exceed RolloverMonitor's 0.74.
constexpr double kRollTilt = 0.8;
// [s] Time over which the tilt is predicted. If smaller: falls are detected later. If larger:
// pushes, which end by themselves, trip.
constexpr double kTiltPrediction = 0.1;
// [s] Time for which the battery charge must be low before it is a fault. If smaller: wrong samples
// trip. Shorter than the 2 s of fault_table().
constexpr double kBatteryTime = 1.0;
// [height of the centre of mass] Largest distance of the capture point outside the triangle of the
// other three feet at which a leg is given up. The damping of the lost leg supports the body over
// this distance for long enough. Test: test_lost_leg.py.
constexpr double kMaxOutside = 0.03;
// [m g] External force above which no leg is given up, because the push will move the capture point
// further.
constexpr double kMaxPush = 0.1;
// Share of missing samples above which kLoss is reported. The rows packet_loss bracket it: 4 % must
// pass, 8 % must be reported.
constexpr double kMaxLoss = 0.05;

}  // namespace

void Supervisor::Impl::judge(const LowState& state, double dt) noexcept {
  motors.update(state, dt, stand.lost_leg(), log);
  judge_legs();
  stand.set_torque_share(motors.torque_share());
  impedance.set_torque_share(motors.torque_share());
  if (is_standing()) {
    estimator_faults.update(stand.estimator_report(), stand.state(), dt, log);
  } else {
    estimator_faults.reset(context.mode == Mode::kSit, log);
  }
  encoders.update(state, dt, stand.lost_leg());
  log.set(FaultId::kEncoder, encoders.motor() >= 0, encoders.motor());
  clock_monitor.update(state, dt);
  log.set(FaultId::kClock, clock_monitor.fast());
  log.set(FaultId::kQuaternion, estimator_faults.quaternion_bad() || !imu.attitude_plausible());
  log.set(FaultId::kAccelerometer, estimator_faults.accelerometer_bad() || imu.accelerometer_bad());
  log.set(FaultId::kGyroscope, estimator_faults.gyroscope_bad() || imu.gyroscope_bad());
  judge_tilt(state);
  judge_rest(state, dt);
}

// Give up the leg of a failed motor if the robot stands and its capture point is inside the
// triangle of the other three feet, or at most kMaxOutside outside.
void Supervisor::Impl::judge_legs() noexcept {
  const int lost = stand.lost_leg();
  if (lost >= 0) {
    if (!log.report().has(FaultId::kLegLost)) log.set(FaultId::kLegLost, true, kLegJoints * lost);
    return;
  }
  for (const FaultId id : {FaultId::kMotorMode, FaultId::kMotorWeak}) {
    if (!log.report().has(id) || !is_standing()) continue;
    const int motor = log.report().motor[static_cast<int>(id)];
    const int leg = motor / kLegJoints;
    const Reference& stand_reference = stand.reference();
    const double height =
        stand_reference.p_com.z() - stand_reference.feet[diagonal_leg(leg)].p_world.z();
    const double push = stand.state().f_external.head<2>().norm();
    // Both comparisons are false for NaN, so the leg is kept.
    const bool quiet = push <= kMaxPush * kGravity * robot.mass();
    if (!quiet || !(stand.capture_margin_without(leg) >= -kMaxOutside * height)) continue;
    stand.declare_leg_lost(leg);
    log.set(id, false);
    log.set(FaultId::kLegLost, true, motor);
    return;
  }
}

void Supervisor::Impl::judge_rest(const LowState& state, double dt) noexcept {
  log.set(FaultId::kLoss, arming.loss() > kMaxLoss);
  const BmsState& bms = state.bms;
  const bool battery_reported = bms.SOC > 0 || bms.bms_status > 0 || bms.version_h > 0;
  log.set(FaultId::kBattery,
          battery.update(battery_reported && bms.SOC < options.battery_low, dt, kBatteryTime));
  const unsigned count = heartbeats;
  operator_silence = count == last_heartbeats ? operator_silence + dt : 0.0;
  last_heartbeats = count;
  log.set(FaultId::kOperator, operator_silence > options.operator_timeout);
}

// Extrapolate the tilt with its rate, so that a fast fall damps early.
void Supervisor::Impl::judge_tilt(const LowState& state) noexcept {
  if (!applies_torque()) {
    log.set(FaultId::kTilt, false);
    return;
  }
  // For a standing robot use the attitude of the StandController's estimator, and the gain
  // fall_tilt as limit.
  Quaternion R = impedance.R_world_base();
  double most = is_raising_body() ? kFallTilt : kRollTilt;
  if (is_standing()) {
    R = Quaternion(stand.state().q.segment<4>(3).data());
    most = stand.gains().fall_tilt;
  }
  const std::array<float, 3> gyroscope = state.imu.gyroscope;  // packed: copied
  const Vector3 w = impedance.R_base_imu() * Vector3(gyroscope[0], gyroscope[1], gyroscope[2]);
  const Vector3 up = R.conjugate() * Vector3::UnitZ();  // in base axes
  const double tilt = tilt_angle(up);
  const double sine = std::max(std::hypot(up.x(), up.y()), 1e-6);  // no division by zero if level
  // d(up)/dt = up x w; the tilt grows as up.z falls.
  const double rate = -up.cross(w).z() / sine;
  // The tilt of a lying body is not predicted, because the body may roll off a leg. Below half the
  // limit no tilt is predicted: pushes turn a level body fast, but end.
  const double ahead = is_standing() || is_raising_body() ? kTiltPrediction : 0.0;
  log.set(FaultId::kTilt, tilt > most || (tilt > 0.5 * most && tilt + ahead * rate > most));
}

void Supervisor::Impl::react() noexcept {
  for (const FaultId stop_fault : {FaultId::kStop, FaultId::kButton}) {
    if (log.report().has(stop_fault)) latch(stop_fault);
  }
  if (!applies_torque()) return;
  // Do not latch here for the sample fault: tick() first repeats the last command for 10 ms.
  const FaultId worst = log.report().first_active(FaultReaction::kDamp, sample_fault);
  if (worst != FaultId::kNone) latch(worst);
  const bool up = context.mode == Mode::kStand || context.mode == Mode::kRise;
  if (up && log.report().first_active(FaultReaction::kSit) != FaultId::kNone)
    enter_mode(Mode::kSit);
}

}  // namespace surefoot
