// SPDX-License-Identifier: BSD-3-Clause
// Detects faults in a usable sample, and reacts to them.
#include <cmath>

#include "supervisor/common/tilt.hpp"
#include "supervisor/supervisor_impl.hpp"

namespace surefoot {

namespace {

// The constants are chosen by hand.
// [rad] 40 degrees: tilt above which a rising or sitting robot has fallen. Larger than the tilt on
// slopes of 8 degrees (benchmarks/false_trips.py), and smaller than the 60 degrees of the row
// body_tilt of `surefoot faults`.
constexpr double kFallTilt = 0.7;
// [rad] 46 degrees: tilt above which a lying body has fallen. Larger than kRolledOverTilt of
// RolloverMonitor (0.74).
constexpr double kLyingFallTilt = 0.8;
// [s] Time over which the tilt is predicted. If shorter: falls are detected later. If longer:
// pushes, which end by themselves, cause a fault.
constexpr double kTiltPrediction = 0.1;
// [s] Time for which the battery charge must be low before there is a fault. If shorter: wrong
// samples cause a fault. Shorter than the 2 s of fault_table().
constexpr double kBatteryTime = 1.0;
// Largest distance of the capture point outside the triangle of the other three feet at which a leg
// is declared lost, as a share of the height of the centre of mass. Up to this distance, the
// damping of the lost leg supports the body for long enough. Test: test_lost_leg.py.
constexpr double kMaxOutside = 0.03;
// [m g] With a larger horizontal external force no leg is declared lost, because the push will move
// the capture point further.
constexpr double kMaxPush = 0.1;
// Share of missing samples above which kLoss is reported. The rows packet_loss of `surefoot faults`
// bracket the value: 4 % must not be reported, 8 % must be.
constexpr double kMaxLoss = 0.05;

}  // namespace

void Supervisor::Impl::judge(const LowState& state, double dt) noexcept {
  motors.update(state, dt, controller.lost_leg(), log);
  judge_legs();
  controller.set_torque_share(motors.torque_share());
  impedance.set_torque_share(motors.torque_share());
  if (is_on_feet()) {
    estimator_faults.update(controller.estimator_report(), controller.state(), is_stepping(), dt,
                            log);
  } else {
    estimator_faults.reset(context.mode == Mode::kSit, log);
  }
  encoders.update(state, dt, controller.lost_leg());
  log.set(FaultId::kEncoder, encoders.motor() >= 0, encoders.motor());
  clock_monitor.update(state, dt);
  if (!is_stepping()) clock_monitor.reset_slow();
  log.set(FaultId::kClock, clock_monitor.fast() || clock_monitor.slow());
  log.set(FaultId::kQuaternion, estimator_faults.quaternion_bad() || !imu.attitude_plausible());
  log.set(FaultId::kAccelerometer, estimator_faults.accelerometer_bad() || imu.accelerometer_bad());
  log.set(FaultId::kGyroscope, estimator_faults.gyroscope_bad() || imu.gyroscope_bad());
  judge_tilt(state);
  judge_loss_battery_and_operator(state, dt);
}

// Declare the leg of a failed motor lost if the robot stands or walks, and its capture point is
// inside the triangle of the other three feet or at most kMaxOutside outside.
void Supervisor::Impl::judge_legs() noexcept {
  const int lost = controller.lost_leg();
  if (lost >= 0) {
    if (!log.report().has(FaultId::kLegLost)) log.set(FaultId::kLegLost, true, kLegJoints * lost);
    return;
  }
  for (const FaultId id : {FaultId::kMotorMode, FaultId::kMotorWeak}) {
    if (!log.report().has(id) || !is_on_feet()) continue;
    const int motor = log.report().motor[static_cast<int>(id)];
    const int leg = motor / kLegJoints;
    const Reference& stand_reference = controller.reference();
    const double height =
        stand_reference.p_com.z() - stand_reference.feet[diagonal_leg(leg)].p_world.z();
    const double push = controller.state().f_external.head<2>().norm();
    // Both comparisons are false for NaN; the leg is then not declared lost.
    const bool push_is_small = push <= kMaxPush * kGravity * robot.mass();
    if (!push_is_small || !(controller.capture_margin_without(leg) >= -kMaxOutside * height))
      continue;
    controller.declare_leg_lost(leg);
    log.set(id, false);
    log.set(FaultId::kLegLost, true, motor);
    return;
  }
}

void Supervisor::Impl::judge_loss_battery_and_operator(const LowState& state, double dt) noexcept {
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

// Report kTilt if the tilt is too large, or will be within kTiltPrediction at its present rate.
void Supervisor::Impl::judge_tilt(const LowState& state) noexcept {
  if (!applies_torque()) {
    log.set(FaultId::kTilt, false);
    return;
  }
  // For a robot on its feet, use the attitude of the controller's estimator, and the gain
  // fall_tilt as the limit.
  Quaternion R = impedance.R_world_base();
  double max_tilt = is_raising_body() ? kFallTilt : kLyingFallTilt;
  if (is_on_feet()) {
    R = Quaternion(controller.state().q.segment<4>(3).data());
    max_tilt = controller.gains().fall_tilt;
  }
  // The field is packed, so it is copied.
  const std::array<float, 3> gyroscope = state.imu.gyroscope;
  const Vector3 w = impedance.R_base_imu() * Vector3(gyroscope[0], gyroscope[1], gyroscope[2]);
  const Vector3 up = R.conjugate() * Vector3::UnitZ();  // in base axes
  const double tilt = tilt_angle(up);
  // Avoids a division by zero if the body is level.
  const double sine = std::max(std::hypot(up.x(), up.y()), 1e-6);
  // d(up)/dt = up x w; the tilt grows as up.z falls.
  const double rate = -up.cross(w).z() / sine;
  // The tilt of a lying body is not predicted, because the body may roll off a leg. A tilt below
  // half of the limit is not predicted either, because pushes turn a level body fast but end by
  // themselves.
  const double prediction_time = is_on_feet() || is_raising_body() ? kTiltPrediction : 0.0;
  log.set(FaultId::kTilt,
          tilt > max_tilt || (tilt > 0.5 * max_tilt && tilt + prediction_time * rate > max_tilt));
}

void Supervisor::Impl::react() noexcept {
  for (const FaultId stop_fault : {FaultId::kStop, FaultId::kButton}) {
    if (log.report().has(stop_fault)) latch(stop_fault);
  }
  if (!applies_torque()) return;
  // The sample fault is not latched here: tick() first repeats the last command for 10 ms, and then
  // latches this fault.
  const FaultId worst = log.report().first_active(FaultReaction::kDamp, sample_fault);
  if (worst != FaultId::kNone) latch(worst);
  const bool sits = log.report().first_active(FaultReaction::kSit) != FaultId::kNone;
  const bool on_way_to_sit = context.stopping && after_stop == Mode::kSit;
  if (active() && context.mode != Mode::kSit && sits && !on_way_to_sit) enter_mode(Mode::kSit);
  const bool must_stand = log.report().stops_walking() != FaultId::kNone;
  if (context.mode == Mode::kWalk && must_stand && !context.stopping) enter_mode(Mode::kStand);
}

}  // namespace surefoot
