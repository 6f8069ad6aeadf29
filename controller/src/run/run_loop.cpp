// SPDX-License-Identifier: BSD-3-Clause
#include "run/run_loop.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dynamics/standing_pose.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

namespace {

// The run ends after this number of datagrams of another frame generation. Chosen larger than a few
// stray datagrams; a robot that sends at 500 Hz reaches this number within 20 ms.
constexpr std::uint64_t kMaxWrongGenerationFrames = 10;

// [standing_height_] Height of the base below which the robot lies. Chosen: half-way. A
// BodyReference lowers the base by less; a robot that lies with folded legs is lower.
constexpr double kLyingShare = 0.5;

double standing_height(const Robot& robot) {
  const Dynamics standing = standing_dynamics(robot);
  return standing.p_world_base().z() - contact_points(standing).row(2).mean();
}

const RunOptions& checked_options(const RunOptions& options) {
  options.validate();
  return options;
}

SupervisorOptions supervisor_options(const RunOptions& options, const ControllerOptions& stand) {
  SupervisorOptions out;
  out.power_level = options.power_level;
  out.start = options.start;
  out.remote = options.remote;
  out.operator_timeout = options.operator_timeout;
  out.stand = stand;
  out.velocity_timeout = options.velocity_timeout;
  return out;
}

}  // namespace

RunLoop::RunLoop(const Robot& robot, const Gains& gains, const ControllerOptions& stand,
                 std::shared_ptr<RobotLink> link, const RunOptions& options)
    : options_(checked_options(options)),
      supervisor_(robot, gains, supervisor_options(options, stand)),
      link_(std::move(link)),
      tau_max_(robot.config().tau_max),
      standing_height_(standing_height(robot)),
      damping_(damping_low_cmd(gains.damping_kd)),
      stick_speeds_(robot),
      log_(static_cast<std::size_t>(std::ceil(options.log_time * options.rate))) {}

void RunLoop::tick(double time, double elapsed) noexcept {
  snapshot_.time = time;
  apply_requests();
  const bool has_new_state = link_->receive();
  if (stop_requested_.load()) end(RunReason::kRequested);
  // If damping is requested while the robot already damps, this request becomes the reason.
  if (damp_requested_.exchange(false) && snapshot_.phase == RunPhase::kDamping)
    snapshot_.reason = RunReason::kRequested;
  if (ended()) {
    send(damping_, has_new_state);
  } else if (link_->has_state()) {
    supervise(has_new_state, elapsed);
  } else {
    wait_for_robot();
  }
  const bool duration_over = duration_start_ >= 0.0 && time - duration_start_ > options_.duration;
  if (duration_over) finish();
  if (finish_requested_.load() && !ended()) sit_down_and_end();
}

void RunLoop::wait_for_robot() noexcept {
  send_damping();
  if (link_->counts().wrong_generation >= kMaxWrongGenerationFrames) {
    end(RunReason::kWrongGeneration);
  } else if (snapshot_.time > options_.connect_timeout) {
    end(RunReason::kNoState);
  }
}

void RunLoop::supervise(bool has_new_state, double elapsed) noexcept {
  snapshot_.ticks += snapshot_.phase != RunPhase::kDamping;
  count_samples();
  if (elapsed > kRobotWatchdogTime) {
    if (supervisor_.armed()) snapshot_.silence_time = elapsed;
    report_link_lost(RunReason::kProcessStalled);
  }
  if (link_->counts().restarts != counted_restarts_) report_link_lost(RunReason::kRestart);
  supervisor_.report_conflict(link_->status().conflict);
  if (link_->status().conflict && supervisor_.armed()) report_link_lost(RunReason::kConflict);
  const double age = link_->state_age();
  if (robot_silent_ && has_new_state && age < kStaleTime) resume_or_report_lost();
  const LowCmd& command = has_new_state && age < kHoldTime ? control(link_->state())
                                                           : update_without_state(age, elapsed);
  if (supervisor_.mode() == Mode::kStand && !snapshot_.stood && lies()) {
    end(RunReason::kNotStanding);
    send(damping_, has_new_state);
    return;
  }
  send(command, has_new_state);
  update_phase();
}

// Return whether a robot with start kStanding lies. The estimator's height is above its feet.
bool RunLoop::lies() const noexcept {
  const double height = supervisor_.controller().state().q[2];
  return options_.start == Start::kStanding && height < kLyingShare * standing_height_;
}

void RunLoop::send(const LowCmd& command, bool has_new_state) noexcept {
  link_->send(command);
  log(command, has_new_state);
}

// The supervisor receives only the newest sample of a tick. So the link's counts of all samples are
// passed to the supervisor too.
void RunLoop::count_samples() noexcept {
  const LinkCounts& counts = link_->counts();
  supervisor_.count_samples(static_cast<double>(counts.valid - counted_valid_),
                            static_cast<double>(counts.lost) - static_cast<double>(counted_lost_));
  counted_valid_ = counts.valid;
  counted_lost_ = counts.lost;
}

const LowCmd& RunLoop::control(const LowState& state) noexcept {
  silence_detector_.on_sample(snapshot_.time, state.tick);
  apply_remote(options_.remote ? decode_wireless_remote(state.wirelessRemote) : WirelessRemote());
  const LowCmd& command = supervisor_.update(state);
  const WalkController& controller = supervisor_.controller();
  snapshot_.controller_status = controller.status();
  snapshot_.controller_fault = controller.fault();
  if (snapshot_.phase != RunPhase::kDamping) {
    const bool on_feet = supervisor_.mode() == Mode::kStand || supervisor_.mode() == Mode::kWalk;
    snapshot_.usable_ticks += supervisor_.command_is_fresh();
    snapshot_.saturated_ticks += on_feet && snapshot_.controller_status == Status::kSaturated;
    snapshot_.greatest_power = std::max(snapshot_.greatest_power, supervisor_.measured_power());
  }
  snapshot_.measured_power = supervisor_.measured_power();
  return command;
}

// Return the command for a tick without a new sample. As the silence grows, this is the last
// command, then damping, and finally latched damping.
const LowCmd& RunLoop::update_without_state(double age, double elapsed) noexcept {
  snapshot_.ticks_without_state += snapshot_.phase != RunPhase::kDamping;
  const LowCmd& command = supervisor_.update_without_state(age);
  if (robot_silent_ && !silence_detector_.recoverable(snapshot_.time))
    report_link_lost(RunReason::kStale);
  if (!robot_silent_ && supervisor_.armed() &&
      silence_detector_.is_silent(age, elapsed, 1.0 / options_.rate)) {
    robot_silent_ = true;
    snapshot_.silence_time = age;
  }
  return command;
}

// Handle the first sample after a silence. If the robot's clock paused during the silence, resume
// control; otherwise report the link as lost.
void RunLoop::resume_or_report_lost() noexcept {
  if (supervisor_.armed() &&
      silence_detector_.robot_clock_paused(snapshot_.time, link_->state().tick)) {
    robot_silent_ = false;
    ++snapshot_.resumed_dampings;
  } else {
    report_link_lost(RunReason::kStale);
  }
}

void RunLoop::report_link_lost(RunReason why) noexcept {
  link_loss_reason_ = why;
  robot_silent_ = false;
  counted_restarts_ = link_->counts().restarts;
  supervisor_.report_link_lost();
}

void RunLoop::sit_down_and_end() noexcept {
  const Mode mode = snapshot_.mode;
  const bool is_up = mode != Mode::kPassive && mode != Mode::kDamping;
  if (mode == Mode::kWalk && snapshot_.phase != RunPhase::kDamping) {
    // The supervisor stops the walk first. The next tick repeats the request.
    supervisor_.request(options_.start == Start::kStanding ? Mode::kStand : Mode::kSit);
  } else if (options_.start == Start::kStanding || snapshot_.phase == RunPhase::kDamping ||
             (!is_up && !supervisor_.fading())) {
    end(RunReason::kRequested);
  } else if (mode == Mode::kRise || mode == Mode::kStand) {
    // The supervisor may reject this request while torques fade. The next tick repeats the request.
    supervisor_.request(Mode::kSit);
  }
}

void RunLoop::end(RunReason why) noexcept {
  // If the robot already damps, the reason for damping is kept. If no valid LowState has arrived,
  // the reason is kNoState, even if the end was requested.
  if (snapshot_.phase == RunPhase::kWaiting && why == RunReason::kRequested)
    why = RunReason::kNoState;
  if (snapshot_.phase != RunPhase::kDamping) snapshot_.reason = why;
  const bool is_lying = snapshot_.mode == Mode::kPassive || snapshot_.mode == Mode::kDamping;
  const bool end_pose_reached = is_lying || options_.start == Start::kStanding;
  snapshot_.stood_to_end =
      why == RunReason::kRequested && stood_as_requested_ && end_pose_reached && !robot_silent_;
  snapshot_.phase = RunPhase::kEnded;
  phase_changed_ = true;
}

}  // namespace surefoot
