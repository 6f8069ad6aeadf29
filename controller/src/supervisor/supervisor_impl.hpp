// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "safety/command_keeper.hpp"
#include "safety/tick_clock.hpp"
#include "supervisor/arming.hpp"
#include "supervisor/height_motion.hpp"
#include "supervisor/leg_folding.hpp"
#include "supervisor/leg_springs.hpp"
#include "supervisor/published.hpp"
#include "supervisor/requests.hpp"
#include "supervisor/torque_fade.hpp"
#include "surefoot/safety.hpp"
#include "surefoot/supervisor.hpp"

namespace surefoot {

/// The mode machine. Everything but `requests`, `report` and `reason` belongs to the tick.
struct Supervisor::Impl {
  Impl(const Robot& robot, const Gains& gains, const SupervisorOptions& options);

  const LowCmd& tick(const LowState& state) noexcept;

  Robot robot;
  SupervisorOptions options;
  RisePlan plan;
  Arming arming;
  LegFolding folding;
  HeightMotion motion;
  LegSprings springs;
  StandController stand;
  Safety safety;
  Requests requests;
  Published<ArmingReport> report;
  std::atomic<DampingReason> reason{DampingReason::kNone};
  std::atomic<bool> gave_up{false};
  std::atomic<double> height{0.0};

 private:
  bool read(const LowState& state, double step) noexcept;
  DampingReason find_fault(const LowState& state) noexcept;
  void obey(int request) noexcept;
  void enter(Mode mode) noexcept;
  void move(double dt) noexcept;
  void rise(double dt) noexcept;
  void sit(double dt) noexcept;
  void lie() noexcept;
  void latch(DampingReason why) noexcept;
  Drive drive(Source source, const LowState& state) noexcept;
  const LowCmd& command(const LowState& state, double dt) noexcept;
  void publish() noexcept;
  bool active() const noexcept { return now.mode != Mode::kPassive && now.mode != Mode::kDamping; }

  RequestContext now;
  TickClock clock;
  CommandKeeper keeper;
  TorqueFade fade;
  JointReference reference;  // of the springs
  bool folded = false;       // is the rise past folding the legs?
  int bad_motors = 0;        // reports in a row
  double damping_kd;
};

}  // namespace surefoot
