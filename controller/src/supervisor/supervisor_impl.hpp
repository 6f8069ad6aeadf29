// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "safety/command_keeper.hpp"
#include "safety/tick_clock.hpp"
#include "supervisor/arming.hpp"
#include "supervisor/clock_watch.hpp"
#include "supervisor/encoder_watch.hpp"
#include "supervisor/fault_log.hpp"
#include "supervisor/height_motion.hpp"
#include "supervisor/imu_watch.hpp"
#include "supervisor/joint_watch.hpp"
#include "supervisor/leg_folding.hpp"
#include "supervisor/leg_lift.hpp"
#include "supervisor/leg_pressing.hpp"
#include "supervisor/leg_springs.hpp"
#include "supervisor/leg_weighing.hpp"
#include "supervisor/motor_faults.hpp"
#include "supervisor/published.hpp"
#include "supervisor/repeated_report.hpp"
#include "supervisor/requests.hpp"
#include "supervisor/sensor_faults.hpp"
#include "supervisor/torque_fade.hpp"
#include "supervisor/torque_rate.hpp"
#include "surefoot/safety.hpp"
#include "surefoot/supervisor.hpp"

namespace surefoot {

/// The mode machine. What is not published, asked for or atomic belongs to the tick.
struct Supervisor::Impl {
  Impl(const Robot& robot, const Gains& gains, const SupervisorOptions& options);

  const LowCmd& tick(const LowState& state) noexcept;
  const LowCmd& bridge(double age) noexcept;
  void lose() noexcept;
  void set_gains(const Gains& gains);

  Robot robot;
  SupervisorOptions options;
  RisePlan plan;
  Arming arming;
  LegFolding folding;
  LegWeighing weighing;
  LegPressing pressing;
  HeightMotion motion;
  LegSprings springs;
  StandController stand;
  Safety safety;
  Requests requests;
  Published<ArmingReport> report;
  Published<FaultReport> faults;
  std::atomic<FaultId> reason{FaultId::kNone};
  std::atomic<unsigned> heartbeats{0};
  std::atomic<bool> gave_up{false};
  std::atomic<RiseStage> shown_stage{RiseStage::kHoldLegs};
  std::atomic<double> height{0.0};
  bool fresh = false;

 private:
  /// [s] After it no command lives: a longer step must be confirmed, for a tick may be mad.
  static constexpr double kLongestStep = 0.015;

  bool read(const LowState& state, double step, double dt) noexcept;
  FaultId find_bad(const LowState& state, double step) noexcept;
  void judge(const LowState& state, double dt) noexcept;
  void judge_tilt(const LowState& state) noexcept;
  void judge_legs() noexcept;
  void judge_rest(const LowState& state, double dt) noexcept;
  void react() noexcept;
  void obey(int request) noexcept;
  void take_over() noexcept;
  void enter(Mode mode) noexcept;
  void start_rise() noexcept;
  void move(const LowState& state, double dt) noexcept;
  void rise(const LowState& state, double dt) noexcept;
  void hold_legs(const LowState& state, double dt) noexcept;
  void fold(double dt) noexcept;
  void weigh(const LowState& state, double dt) noexcept;
  void press(const LowState& state, double dt) noexcept;
  void go_up(const LowState& state, double dt) noexcept;
  void refuse(FaultId why, int motor) noexcept;
  void sit(double dt) noexcept;
  void lie() noexcept;
  void forget() noexcept;
  void latch(FaultId why) noexcept;
  Drive drive(Source source, const LowState& state) noexcept;
  const LowCmd& command(const LowState& state, double dt) noexcept;
  void publish() noexcept;
  bool active() const noexcept { return now.mode != Mode::kPassive && now.mode != Mode::kDamping; }
  bool drives() const noexcept {
    return active() || fade.moving();
  }  ///< torques, not damping alone
  bool upward() const noexcept { return stage == RiseStage::kUp; }
  bool standing() const noexcept { return now.mode == Mode::kStand && !fade.moving(); }

  RequestContext now;
  TickClock clock{kLongestStep};
  CommandKeeper keeper;
  TorqueFade fade;
  JointReference reference;  // of the springs
  RiseStage stage = RiseStage::kHoldLegs;
  LegLift lift;
  FaultLog log;
  MotorFaults motors;
  SensorFaults sensors;
  TorqueRate rate;
  RepeatedReport repeated;
  std::uint32_t last_tick = 0;
  bool known = false;     // has it ever been heard, since it was lost?
  double unheard = 0.0;   // [s] in which every report was bad
  double unlooked = 0.0;  // [s] in which no report's numbers could be looked at, up to the last
  ImuWatch imu;
  JointWatch joints;
  EncoderWatch encoders;
  ClockWatch pace;
  Lasting battery, held_back, unsolved;
  FaultId bad = FaultId::kNone;  // what is wrong with the report itself
  unsigned heard = 0;            // heartbeats
  double silence = 0.0;          // [s] since the last of them
  double damping_kd;
};

}  // namespace surefoot
