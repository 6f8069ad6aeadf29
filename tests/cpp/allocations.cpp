// SPDX-License-Identifier: BSD-3-Clause
// Count heap allocations and exceptions of a tick. malloc and its relatives
// (benchmarks/ticks/memory_counters.cpp) and __cxa_throw are replaced for the whole executable.
#include <dlfcn.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "lambda_planner.hpp"
#include "random_disturbances.hpp"
#include "random_qp.hpp"
#include "robot_states.hpp"
#include "safety/fallback_chain.hpp"
#include "surefoot/safety.hpp"
#include "surefoot/stand_controller.hpp"
#include "surefoot/supervisor.hpp"
#include "surefoot/walk_controller.hpp"
#include "ticks/memory_counters.hpp"
#include "wbc/qp_solver.hpp"

namespace {
long exceptions = 0;
}

// Bound by its assembler label, because compilers declare __cxa_throw themselves and disagree on
// the type of its second argument.
using Destructor = void (*)(void*);
[[noreturn]] void counted_throw(void* thrown, void* type, Destructor destructor) asm("__cxa_throw");
void counted_throw(void* thrown, void* type, Destructor destructor) {
  ++exceptions;
  using Throw = void (*)(void*, void*, Destructor);
  reinterpret_cast<Throw>(dlsym(RTLD_NEXT, "__cxa_throw"))(thrown, type, destructor);
  std::abort();
}

namespace {

using namespace surefoot;

/// A user's task: its rows change, every 331st call is too heavy for the first solve, and every
/// 977th call fails.
struct UserTask : Task {
  int rows() const override { return 2; }
  bool write(const RobotState& state, TaskRows& rows) noexcept override {
    rows.A_a(0, 2) = 0.05;
    rows.A_a(1, 7) = 0.05;
    rows.A_f(0, 2) = 0.01;
    rows.b << -0.5 * state.v[2], -0.5 * state.v[7];
    rows.weight[0] = 1.0;
    if (++calls % 331 == 0) {
      rows.weight[0] = 4e6;
      rows.b[0] = 1.5e5;
    }
    return calls % 977 != 0;
  }
  long calls = 0;
};

/// A user's planner: it keeps the pose of its first tick and writes a posture. Every 331st plan
/// fails, and every 577th has a NaN.
struct UserPlanner : LambdaPlanner {
  UserPlanner() {
    change = [this](const PlannerInput&, Reference& reference) {
      reference.posture[0] += 1e-6;
      if (++plans % 577 == 0) reference.feet[FL_].p_world.x() = std::nan("");
      return plans % 331 != 0;
    };
  }
  long plans = 0;
};

struct TickCounts {
  long general = 0, condensed = 0, yielding = 0, stopped = 0, damping = 0, faults = 0,
       power_limited = 0, lifted = 0;
  long refused = 0, cold = 0, forces = 0, held = 0;
  long allocations = 0, exceptions = 0;
};

TickCounts run(const Robot& robot, QpForm form, double delay, std::uint32_t ticks) {
  ControllerOptions options;
  options.form = form;
  options.delay = delay;
  options.power_limit = 150.0;
  Gains gains;
  gains.weight_momentum = gains.weight_posture = gains.weight_smooth = 0.01;
  gains.edge_rise = 0.8;
  StandController controller(robot, gains, options);
  controller.add_task(std::make_shared<UserTask>());
  RandomDisturbances disturbances(robot);
  Safety safety(robot);
  TickCounts tick_counts;
  const long allocations_before = bench::heap_allocations(), exceptions_before = exceptions;
  for (std::uint32_t tick = 1; tick <= ticks; ++tick) {
    if (tick % 400 == 0) controller.set_body_reference(disturbances.reference());
    if (tick % 2100 == 0) controller.set_body_reference({0.0, std::nan(""), 0.0, 0.0, 0.0, 0.0});
    const LowState& report = disturbances.report(tick);
    LowCmd command = controller.update(report);
    safety.position_limit(command);
    const bool safe =
        safety.power_protect(command, report, 1) + safety.position_protect(command, report) == 2;
    tick_counts.refused += !safe;
    tick_counts.power_limited += controller.power_scale() < 1.0;
    for (const FootReference& foot : controller.reference().feet)
      tick_counts.lifted += !foot.stance;
    const Solution& s = controller.solution();
    (s.form == QpForm::kGeneral ? tick_counts.general : tick_counts.condensed) += 1;
    tick_counts.yielding +=
        s.torque_limit_violation + s.joint_limit_violation + s.hold_down_violation > 1e-3;
    tick_counts.stopped += controller.reach().limit != ReachLimit::kNone;
    tick_counts.faults += !is_usable(controller.status());
    if (controller.status() != Status::kDamping) continue;
    ++tick_counts.damping;
    controller.reset();
  }
  tick_counts.allocations = bench::heap_allocations() - allocations_before;
  tick_counts.exceptions = exceptions - exceptions_before;
  tick_counts.cold = static_cast<long>(controller.fallback_count(FallbackLevel::kColdSolve));
  tick_counts.forces = static_cast<long>(controller.fallback_count(FallbackLevel::kForces));
  tick_counts.held = static_cast<long>(controller.fallback_count(FallbackLevel::kHold));
  return tick_counts;
}

struct PlannedCounts {
  long solved = 0, bad_references = 0, damping = 0;
  long allocations = 0, exceptions = 0;
};

// Run a Controller with a user's planner; one leg is lost in part of the ticks.
PlannedCounts run_planner(const Robot& robot) {
  Controller controller(robot, std::make_shared<UserPlanner>());
  RandomDisturbances disturbances(robot);
  PlannedCounts tick_counts;
  const long allocations_before = bench::heap_allocations(), exceptions_before = exceptions;
  for (std::uint32_t tick = 1; tick <= 25000; ++tick) {
    controller.update(disturbances.report(tick));
    tick_counts.solved += is_usable(controller.status());
    tick_counts.bad_references += controller.status() == Status::kBadReference;
    if (tick % 2500 == 0) controller.declare_leg_lost(RR_);
    if (controller.status() != Status::kDamping) continue;
    ++tick_counts.damping;
    controller.reset();
  }
  tick_counts.allocations = bench::heap_allocations() - allocations_before;
  tick_counts.exceptions = exceptions - exceptions_before;
  return tick_counts;
}

struct WalkCounts {
  long standing = 0, walking = 0, stops = 0, swing_feet = 0, unusable = 0, pushed = 0;
  long allocations = 0, exceptions = 0;
};

// Let the robot stand, walk and stop in turn. Its samples are those of a robot that does not move;
// the swing feet show no load. If `varied`, velocities and gaits change, and the accelerometer
// shows pushes; such a robot seldom comes to rest.
WalkCounts run_walk(const Robot& robot, bool varied) {
  WalkController controller(robot);
  LowState report = resting_sample(robot, 0);
  const LowState rest = report;
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  WalkVelocity velocity{0.5, 0.1, 0.0};
  WalkCounts tick_counts;
  const long allocations_before = bench::heap_allocations(), exceptions_before = exceptions;
  for (int tick = 0; tick < 25000; ++tick) {
    const bool was_walking = controller.walking();
    if (varied && tick % 250 == 0)
      velocity = {uniform(generator), uniform(generator), uniform(generator)};
    if (varied && tick % 2500 == 0)
      controller.set_gait(tick % 5000 == 0 ? Gait::kTrot : Gait::kWalk);
    if (tick % 2500 >= 500 && tick % 2500 < 1500) controller.set_velocity(velocity);
    const bool pushed = varied && tick % 2500 >= 900 && tick % 2500 < 950;
    report.imu.accelerometer[1] = rest.imu.accelerometer[1] + (!pushed          ? 0.0F
                                                               : tick % 50 < 25 ? 4.0F
                                                                                : -4.0F);
    tick_counts.pushed += pushed;
    if (tick % 2500 == 1700) controller.set_velocity({std::nan(""), 0.0, 0.0});
    report.tick += 2;
    for (int leg = 0; leg < kLegs; ++leg) {
      const bool in_air = controller.planned_loads()[leg] == 0.0;
      report.footForceEst[leg] = static_cast<std::int16_t>(in_air ? 0 : 30 + tick % 2);
    }
    controller.update(report);
    tick_counts.unusable += !is_usable(controller.status());
    ++(controller.walking() ? tick_counts.walking : tick_counts.standing);
    tick_counts.stops += was_walking && !controller.walking();
    for (const FootReference& foot : controller.reference().feet)
      tick_counts.swing_feet += !foot.stance;
  }
  tick_counts.allocations = bench::heap_allocations() - allocations_before;
  tick_counts.exceptions = exceptions - exceptions_before;
  return tick_counts;
}

// Simulate a robot without mass for 2 ms. Each joint moves at the speed at which its damping
// balances the torque. The ground reacts as in the standing pose, but not while the motors give no
// torque.
void simulate_massless_robot(const LowCmd& command, const LowState& standing, LowState& report) {
  report.tick += 2;
  report.imu.gyroscope[2] = report.tick % 4 == 0 ? 1e-5F : -1e-5F;
  report.imu.accelerometer[0] = report.imu.gyroscope[2];
  for (int i = 0; i < kMotors; ++i) {
    const MotorCmd& motor = command.motorCmd[i];
    MotorState& joint = report.motorState[i];
    const float pull = motor.tau == 0.0F ? 0.0F : motor.tau - standing.motorState[i].tauEst;
    joint.dq = motor.Kd > 1.0F ? std::clamp(pull / motor.Kd, -5.0F, 5.0F) : 0.0F;
    joint.tauEst = motor.tau - (motor.Kd > 0.0F ? motor.Kd * joint.dq : 0.0F);
    joint.q += 0.002F * joint.dq;
  }
}

struct SupervisedCounts {
  std::array<long, 6> ticks{};  // per mode
  long allocations = 0, exceptions = 0;
};

// Run rise, walk, sit, stop and arm requests in turn. All calls except the constructor are counted.
SupervisedCounts run_supervisor(const Robot& robot) {
  Supervisor supervisor(robot);
  const LowState standing = resting_sample(robot, 0);
  LowState report = standing;
  SupervisedCounts tick_counts;
  const long allocations_before = bench::heap_allocations(), exceptions_before = exceptions;
  for (int tick = 0; tick < 25000; ++tick) {
    simulate_massless_robot(supervisor.update(report), standing, report);
    const Mode mode = supervisor.mode();
    ++tick_counts.ticks[static_cast<int>(mode)];
    if (!supervisor.armed()) supervisor.arm();
    if (mode == Mode::kPassive) supervisor.request(Mode::kRise);
    if (mode == Mode::kStand && tick % 200 == 0) supervisor.request(Mode::kWalk);
    if (tick % 1000 < 700) supervisor.set_velocity({0.2, 0.0, 0.3});
    if (tick % 1500 == 0) supervisor.request(Mode::kSit);
    if (tick % 9000 == 0) supervisor.stop();
    if (tick % 300 == 7) supervisor.update_without_state(0.004);
    if (tick % 12000 == 11) supervisor.report_link_lost();
    supervisor.count_samples(1.0, 0.0);
  }
  tick_counts.allocations = bench::heap_allocations() - allocations_before;
  tick_counts.exceptions = exceptions - exceptions_before;
  return tick_counts;
}

// Count the allocations of ProxQP, which the ticks above hardly ever use. With max_changes = 0 it
// replaces the active-set method.
long fallback_allocations() {
  QpSolver solver(12, 0, 72, 1e-6, 0);
  long found = 0, iterations = 0;
  for (int seed = 0; seed < 200; ++seed) {
    const RandomQp random(seed);
    const long before = bench::heap_allocations();
    iterations += solver.solve(random.problem).iterations;
    found += bench::heap_allocations() - before;
  }
  std::printf("ProxQP, 200 QPs, %ld iterations: %ld allocations\n", iterations, found);
  return iterations > 1000 ? found : -1;
}

// Count the allocations of the fallback levels that valid states never reach: last forces, gravity,
// hold.
long fallback_chain_allocations(const Robot& robot) {
  FallbackChain chain(robot);
  RobotState state = standing_state(robot);
  Reference reference = reference_at(robot, state);
  reference.p_com.x() = std::nan("");
  const FeetMatrix planned = FeetMatrix::Constant(10.0);
  Dynamics dynamics(robot);
  const Gains gains;
  std::array<long, kFallbackLevels> found{};
  const long before = bench::heap_allocations();
  for (const double angle : {0.8, std::nan("")}) {
    state.q[8] = angle;
    dynamics.update(state.q, state.v, Vector3::UnitZ());
    for (const bool known : {true, false}) {
      chain.reset();
      if (known) chain.remember(gains, dynamics, state, reference, planned);
      ++found[static_cast<int>(chain.compute_fallback(gains, dynamics, state, reference))];
    }
  }
  const long allocations = bench::heap_allocations() - before;
  std::printf("fallback chain: %ld allocations; last forces %ld, gravity %ld, hold %ld\n",
              allocations, found[3], found[4], found[5]);
  return found[3] == 1 && found[4] == 1 && found[5] == 2 ? allocations : -1;
}

// Check that the counters see an allocation and an exception.
bool counters_work() {
  const long before = bench::heap_allocations();
  std::free(std::malloc(8));
  try {
    throw 1;
  } catch (int) {
  }
  return bench::heap_allocations() > before && exceptions == 1;
}

}  // namespace

int main() {
  const Robot robot = quadruped();
  bool good =
      counters_work() && fallback_allocations() == 0 && fallback_chain_allocations(robot) == 0;
  for (const QpForm form : {QpForm::kAuto, QpForm::kGeneral}) {
    for (const double delay : {0.0, 0.01}) {
      const TickCounts s = run(robot, form, delay, 25000);
      std::printf(
          "%s, delay %.0f ms, 25000 ticks: %ld allocations, %ld exceptions; "
          "general %ld, condensed %ld, soft limits violated %ld, reference stopped %ld, "
          "unusable ticks %ld, damping %ld, power limited %ld, protections tripped %ld, "
          "cold solves %ld, fallback forces %ld, holds %ld, feet lifted %ld\n",
          to_string(form), 1e3 * delay, s.allocations, s.exceptions, s.general, s.condensed,
          s.yielding, s.stopped, s.faults, s.damping, s.power_limited, s.refused, s.cold, s.forces,
          s.held, s.lifted);
      good = good && s.lifted > 100 && s.yielding > 100 && s.stopped > 1000 && s.faults > 100 &&
             s.damping >= 4 && s.power_limited > 100 && s.refused > 100 && s.general > 500 &&
             s.cold > 10 && s.forces > 10 && s.held > 10 &&
             (form == QpForm::kGeneral || s.condensed > 1000) && s.allocations == 0 &&
             s.exceptions == 0;
    }
  }
  const PlannedCounts planned = run_planner(robot);
  std::printf(
      "user's planner, 25000 ticks: %ld allocations, %ld exceptions; solved %ld, bad references "
      "%ld, damping %ld\n",
      planned.allocations, planned.exceptions, planned.solved, planned.bad_references,
      planned.damping);
  good = good && planned.solved > 1000 && planned.bad_references > 10 && planned.damping > 4 &&
         planned.allocations == 0 && planned.exceptions == 0;
  for (const bool varied : {false, true}) {
    const WalkCounts walk = run_walk(robot, varied);
    std::printf(
        "%s walk, 25000 ticks: %ld allocations, %ld exceptions; standing %ld, walking %ld, stops "
        "%ld, swing feet %ld, unusable ticks %ld, pushed %ld\n",
        varied ? "varied" : "plain", walk.allocations, walk.exceptions, walk.standing, walk.walking,
        walk.stops, walk.swing_feet, walk.unusable, walk.pushed);
    const bool as_planned = varied ? walk.pushed > 400 : walk.standing > 5000 && walk.stops >= 10;
    good = good && as_planned && walk.walking > 5000 && walk.swing_feet > 5000 &&
           walk.unusable == 0 && walk.allocations == 0 && walk.exceptions == 0;
  }
  const SupervisedCounts s = run_supervisor(robot);
  std::printf(
      "supervised, 25000 ticks: %ld allocations, %ld exceptions; passive %ld, rise %ld, "
      "stand %ld, walk %ld, sit %ld, damping %ld\n",
      s.allocations, s.exceptions, s.ticks[0], s.ticks[1], s.ticks[2], s.ticks[3], s.ticks[4],
      s.ticks[5]);
  for (const long ticks : s.ticks) good = good && ticks > 100;
  return good && s.allocations == 0 && s.exceptions == 0 ? 0 : 1;
}
