// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/faults/motor_faults.hpp"

#include <algorithm>
#include <cmath>

#include "safety/motor_limits.hpp"

namespace surefoot {

namespace {

constexpr int kBadModes = 2;               // reports in a row
constexpr int kBadAngles = 3;              // reports in a row
constexpr double kTorqueTime = 0.03;       // [s] smoothing, longer than delay and lag of a motor
constexpr double kTorqueOff = 0.12;        // of tau_max that a motor may be off ...
constexpr double kTorqueOffShare = 0.4;    // ... and of what it is told
constexpr double kErrorClamp = 2.0;        // times that: no report is taken to be further off
constexpr double kIdleTorqueShare = 0.3;   // of what a motor is told: less is as good as none ...
constexpr double kMinCommandShare = 0.05;  // ... once it is told that much of tau_max ...
constexpr double kMinIdleShare = 0.8;      // ... in that share of reports
constexpr double kWeakTime = 0.05;         // [s]
constexpr double kMinAlternation =
    0.03;  // of tau_max: torques that go to and fro, report by report
constexpr double kAlternationRatio = 4.0;  // times what they are told to
constexpr double kAlternationTime = 0.05;  // [s] smoothing
constexpr double kTemperatureTime = 0.5;   // [s] smoothing: one mad report is no heat
constexpr double kOverheatedTime = 0.5;    // [s] before the robot sits down

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

// Told and measured through the same filter: what the motor's own delay and lag shift is small
// beside what a dead motor leaves out.
void MotorFaults::judge_torques(const LowState& state, double dt, int lost_leg,
                                FaultLog& log) noexcept {
  const double share = -std::expm1(-dt / kTorqueTime);
  const int disturbed = count_alternating_legs(state, dt, lost_leg);
  int weak = -1, legs = 0, last_leg = -1;
  for (int i = 0; i < kMotors; ++i) {
    if (i / kLegJoints == lost_leg) continue;
    expected_[i] += share * (commanded_[i] - expected_[i]);
    const double tau_est = state.motorState[i].tauEst, tau_max = robot_.config().tau_max[i];
    const double allowed = kTorqueOff * tau_max + kTorqueOffShare * std::abs(expected_[i]);
    // What a few mad reports say counts for no more than any that is off.
    const double off_by =
        std::clamp(tau_est - expected_[i], -kErrorClamp * allowed, kErrorClamp * allowed);
    measured_[i] += share * (expected_[i] + off_by - measured_[i]);
    // A motor that sleeps under a foot that bears little is not far off; its reports are counted.
    idle_share_[i] += share * (is_idle(expected_[i], tau_est, tau_max) - idle_share_[i]);
    const bool off =
        std::abs(measured_[i] - expected_[i]) > allowed || idle_share_[i] > kMinIdleShare;
    if (!deviating_[i].update(off, dt, kWeakTime)) continue;
    if (weak < 0) weak = i;
    if (i / kLegJoints != last_leg) ++legs;
    last_leg = i / kLegJoints;
  }
  log.set(FaultId::kOverridden, legs > 1 || disturbed > 1, weak);
  log.set(FaultId::kMotorWeak, legs == 1, weak);
}

// Two who command in turn make torques go to and fro, which the mean hides. Neither delay nor lag
// of a motor makes more of that than there is in what it is told.
int MotorFaults::count_alternating_legs(const LowState& state, double dt, int lost_leg) noexcept {
  const double share = -std::expm1(-dt / kAlternationTime);
  int legs = 0, last_leg = -1;
  for (int i = 0; i < kMotors; ++i) {
    if (i / kLegJoints == lost_leg) continue;
    const double commanded = commanded_alternation_[i].update(commanded_[i], share);
    const double least = kMinAlternation * robot_.config().tau_max[i];
    const double measured =
        measured_alternation_[i].update(state.motorState[i].tauEst, share, least);
    const bool off = measured > least * least + kAlternationRatio * std::max(commanded, 0.0) &&
                     measured_alternation_[i].is_frequent();
    if (!off || i / kLegJoints == last_leg) continue;
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
    const double over = std::clamp(
        (temperature_[i] - temperature_warning_) / (temperature_stop_ - temperature_warning_), 0.0,
        1.0);
    torque_share_[i] = 1.0 - (1.0 - kLeastShare) * over;
  }
  log.set(FaultId::kTemperature,
          overheated_.update(temperature_[hottest] >= temperature_stop_, dt, kOverheatedTime),
          hottest);
}

void MotorFaults::judge_angles(const LowState& state, int lost_leg, FaultLog& log) noexcept {
  LowState judged = state;
  for (int i = kLegJoints * lost_leg; lost_leg >= 0 && i < kLegJoints * (lost_leg + 1); ++i) {
    const double middle = 0.5 * (robot_.config().q_lower[i] + robot_.config().q_upper[i]);
    judged.motorState[i].q = static_cast<float>(middle);
  }
  // The command is not read.
  const bool inside = safety_.position_protect(LowCmd{}, judged, joint_margin_) > 0;
  bad_angles_ = inside ? 0 : bad_angles_ + 1;
  log.set(FaultId::kJointStop, bad_angles_ >= kBadAngles, safety_.position_motor());
}

}  // namespace surefoot
