// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/faults/motor_faults.hpp"

#include <algorithm>
#include <cmath>

#include "safety/motor_limits.hpp"

namespace surefoot {

namespace {

// The constants are chosen by hand. The rows tau_mismatch, motor_dead, two_controllers and
// over_temperature of `surefoot faults` bracket the values. benchmarks/false_trips.py checks that
// healthy robots pass.
//
// Numbers of consecutive bad samples from which there is a fault: of motor modes and of joint
// angles. More than one wrong sample, and at most 3 periods, the 6 ms of fault_table().
constexpr int kBadModes = 2;
constexpr int kBadAngles = 3;
// [s] Time constant of the mean torques. Longer than a motor's delay (two periods) and lag (2 ms).
// Shorter than the 0.15 s of fault_table().
constexpr double kTorqueTime = 0.03;
// Tolerance of a torque error: kTorqueTolerance tau_max + kTorqueToleranceShare |command|. Larger
// than the error that causes no fault: torque errors of 5 %, a delay of 20 ms, or a tauEst of 0 in
// one sample of ten. Smaller than the error of a dead motor.
constexpr double kTorqueTolerance = 0.12;
constexpr double kTorqueToleranceShare = 0.4;
// Limit of the torque error in one sample, as a multiple of the tolerance.
constexpr double kErrorClamp = 2.0;
// A motor is idle in a sample if its torque is below kIdleTorqueShare of the command, and the
// command is above kMinCommandShare of tau_max. A motor that is idle in more than kMinIdleShare of
// the samples is weak. So a dead motor that still reports servo mode is found, see
// docs/reference/fault-injection.md.
constexpr double kIdleTorqueShare = 0.3;
constexpr double kMinCommandShare = 0.05;
constexpr double kMinIdleShare = 0.8;
// [s] Time for which a motor must deviate before it is weak. Longer than impacts. Shorter than the
// 0.15 s of fault_table().
constexpr double kWeakTime = 0.05;
// The torque of a motor alternates if its Alternation is above (kMinAlternation tau_max)^2 plus
// kAlternationRatio times the Alternation of its commands. Larger than the Alternation caused by
// noise and by one wrong sample. Smaller than the Alternation of torques that two programs command
// in turns.
constexpr double kMinAlternation = 0.03;
constexpr double kAlternationRatio = 4.0;
// [s] Time constant of the alternations. Shorter than the 0.2 s of fault_table().
constexpr double kAlternationTime = 0.05;
// [s] Time constant of the mean temperatures. So long that 120 deg C in one sample of 25 is no
// fault.
constexpr double kTemperatureTime = 0.5;
// [s] Time above temperature_stop after which the robot sits down. The sum of this time and
// kTemperatureTime is shorter than the 2 s of fault_table().
constexpr double kOverheatedTime = 0.5;

bool is_idle(double commanded, double measured, double tau_max) noexcept {
  const double amount = std::abs(commanded);
  return amount > kMinCommandShare * tau_max &&
         std::copysign(1.0, commanded) * measured < kIdleTorqueShare * amount;
}

}  // namespace

void MotorFaults::reset() noexcept {
  commanded_.setZero();
  expected_.setZero();
  measured_.setZero();
  idle_share_.setZero();
  commanded_alternation_ = measured_alternation_ = {};
  deviating_ = {};
  overheated_ = {};
  bad_modes_ = bad_angles_ = 0;
}

void MotorFaults::update(const LowState& state, double dt, int lost_leg, FaultLog& log) noexcept {
  judge_modes(state, lost_leg, log);
  judge_torques(state, dt, lost_leg, log);
  judge_temperatures(state, dt, log);
  judge_angles(state, lost_leg, log);
}

void MotorFaults::record_command(const LowCmd& command, const LowState& state) noexcept {
  for (int i = 0; i < kMotors; ++i) {
    const MotorCmd& motor = command.motorCmd[i];
    const double dq = state.motorState[i].dq;
    const double tau = motor.tau - (motor.Kd > 0.0F ? motor.Kd * dq : 0.0);
    commanded_[i] = within_motor_limits(robot_.config(), i, tau, dq);
  }
}

void MotorFaults::judge_modes(const LowState& state, int lost_leg, FaultLog& log) noexcept {
  int bad = -1;
  for (int i = 0; i < kMotors && bad < 0; ++i) {
    const bool judged = i / kLegJoints != lost_leg;
    if (judged && state.motorState[i].mode != kModeServo) bad = i;
  }
  bad_modes_ = bad < 0 ? 0 : bad_modes_ + 1;
  log.set(FaultId::kMotorMode, bad_modes_ >= kBadModes, bad);
}

// Commands and measurements pass the same low-pass. With its time constant, a motor's delay and lag
// cause a smaller error than a dead motor.
void MotorFaults::judge_torques(const LowState& state, double dt, int lost_leg,
                                FaultLog& log) noexcept {
  const double share = -std::expm1(-dt / kTorqueTime);
  const int alternating_legs = count_alternating_legs(state, dt, lost_leg);
  int weak = -1, legs = 0, last_leg = -1;
  for (int i = 0; i < kMotors; ++i) {
    if (i / kLegJoints == lost_leg) continue;
    expected_[i] += share * (commanded_[i] - expected_[i]);
    const double tau_est = state.motorState[i].tauEst, tau_max = robot_.config().tau_max[i];
    const double allowed =
        kTorqueTolerance * tau_max + kTorqueToleranceShare * std::abs(expected_[i]);
    // The error is limited, so that a few wrong samples do not dominate the mean.
    const double limited_error =
        std::clamp(tau_est - expected_[i], -kErrorClamp * allowed, kErrorClamp * allowed);
    measured_[i] += share * (expected_[i] + limited_error - measured_[i]);
    // In a lightly loaded leg the error of a dead motor may be within the tolerance. So the share
    // of idle samples is a second criterion.
    idle_share_[i] += share * (is_idle(expected_[i], tau_est, tau_max) - idle_share_[i]);
    const bool deviates =
        std::abs(measured_[i] - expected_[i]) > allowed || idle_share_[i] > kMinIdleShare;
    if (!deviating_[i].update(deviates, dt, kWeakTime)) continue;
    if (weak < 0) weak = i;
    if (i / kLegJoints != last_leg) ++legs;
    last_leg = i / kLegJoints;
  }
  log.set(FaultId::kOverridden, legs > 1 || alternating_legs > 1, weak);
  log.set(FaultId::kMotorWeak, legs == 1, weak);
}

// If two programs command the robot in turns, the torques alternate, but their means may be normal.
// A motor's delay and lag cannot make the torques alternate more than the commands.
int MotorFaults::count_alternating_legs(const LowState& state, double dt, int lost_leg) noexcept {
  const double share = -std::expm1(-dt / kAlternationTime);
  int legs = 0, last_leg = -1;
  for (int i = 0; i < kMotors; ++i) {
    if (i / kLegJoints == lost_leg) continue;
    const double commanded = commanded_alternation_[i].update(commanded_[i], share);
    const double min_amplitude = kMinAlternation * robot_.config().tau_max[i];
    const double measured =
        measured_alternation_[i].update(state.motorState[i].tauEst, share, min_amplitude);
    const bool deviates =
        measured > min_amplitude * min_amplitude + kAlternationRatio * std::max(commanded, 0.0) &&
        measured_alternation_[i].is_frequent();
    if (!deviates || i / kLegJoints == last_leg) continue;
    ++legs;
    last_leg = i / kLegJoints;
  }
  return legs;
}

void MotorFaults::judge_temperatures(const LowState& state, double dt, FaultLog& log) noexcept {
  const double share = started_ ? -std::expm1(-dt / kTemperatureTime) : 1.0;
  started_ = true;
  int hottest = 0;
  for (int i = 0; i < kMotors; ++i) {
    temperature_[i] += share * (state.motorState[i].temperature - temperature_[i]);
    if (temperature_[i] > temperature_[hottest]) hottest = i;
    const double excess = std::clamp(
        (temperature_[i] - temperature_warning_) / (temperature_stop_ - temperature_warning_), 0.0,
        1.0);
    torque_share_[i] = 1.0 - (1.0 - kMinTorqueShare) * excess;
  }
  log.set(FaultId::kTemperature,
          overheated_.update(temperature_[hottest] >= temperature_stop_, dt, kOverheatedTime),
          hottest);
}

void MotorFaults::judge_angles(const LowState& state, int lost_leg, FaultLog& log) noexcept {
  // position_protect() checks all joints, so the joints of a lost leg get angles within the limits.
  LowState judged = state;
  for (int i = kLegJoints * lost_leg; lost_leg >= 0 && i < kLegJoints * (lost_leg + 1); ++i) {
    const double middle = 0.5 * (robot_.config().q_lower[i] + robot_.config().q_upper[i]);
    judged.motorState[i].q = static_cast<float>(middle);
  }
  // position_protect() does not read the command.
  const bool inside = safety_.position_protect(LowCmd{}, judged, joint_margin_) > 0;
  bad_angles_ = inside ? 0 : bad_angles_ + 1;
  log.set(FaultId::kJointStop, bad_angles_ >= kBadAngles, safety_.position_motor());
}

}  // namespace surefoot
