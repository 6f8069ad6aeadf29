// SPDX-License-Identifier: BSD-3-Clause
// What a report is worth.
#include <cmath>
#include <utility>

#include "low_state_check.hpp"
#include "supervisor/supervisor_impl.hpp"

namespace surefoot {

bool Supervisor::Impl::read(const LowState& state, double step, double dt) noexcept {
  const FaultId before = bad;
  bad = step < 0.0 ? FaultId::kStaleTick : find_bad(state, step);
  if (bad != before) log.set(before, false);
  if (bad != FaultId::kNone) log.set(bad, true);
  const FaultId sits = log.report().first(FaultReaction::kSit);
  const FaultId down = log.report().has(FaultId::kButton) ? FaultId::kButton : sits;
  arming.keep_down(bad != FaultId::kNone ? bad : down);
  // Who lies and was not heard for long, or began anew, may be another one than was armed.
  const double since = 1e-3 * static_cast<std::int32_t>(state.tick - last_tick);
  if (known && !active() && !now.trusted && !arming.told() && std::abs(since) > kStaleTime) {
    now.armed = false;
    arming.distrust();
    fade.jump(Source::kDamping);  // springs that were fading out belong to another moment
  }
  last_tick = state.tick;
  if (step < 0.0) {
    arming.missed();
    // Nothing hangs on its time now: a robot that began anew is taken as it is.
    if (!active()) clock.reset();
  } else {
    arming.update(state, step);
    if (bad != FaultId::kNone) arming.distrust();
  }
  if (bad == FaultId::kNone) {
    if (has_quaternion(state.imu)) springs.read(state);
    now.seen = known = true;
  }
  unheard = bad == FaultId::kNone ? 0.0 : unheard + dt;
  if (unheard > kStaleTime) {
    requests.take();
    if (now.trusted) now.seen = false;  // no arming check would refuse it
  }
  // Who lies down without a leg does not rise again before it is armed anew.
  const bool without_leg = active() && stand.lost_leg() >= 0;
  now.must_sit = down != FaultId::kNone || without_leg;
  now.ready = arming.report().ready && !now.must_sit;
  return bad == FaultId::kNone;
}

// What makes a report nothing to act upon.
FaultId Supervisor::Impl::find_bad(const LowState& state, double step) noexcept {
  repeated.update(state, step);
  unlooked += step;
  const Status status = check_low_state(state, robot.config());
  if (status == Status::kNonFinite) return FaultId::kStateNotFinite;
  if (status != Status::kOk) return FaultId::kStateImplausible;
  // The torque protections' last word, for every report whose numbers can be: a blow that the IMU
  // is not believed about takes power all the same. The command is not read.
  const bool protect = drives() && options.power_level > 0;
  if (!protect) safety.reset();
  log.set(FaultId::kPower,
          protect && safety.power_protect(LowCmd{}, state, options.power_level) < 0);
  const double elapsed = std::exchange(unlooked, 0.0);
  const bool joints_fit = joints.update(state, elapsed, stand.lost_leg());
  imu.update(state.imu, elapsed, !repeated.repeats(), now.mode != Mode::kStand);
  if (!joints_fit) return FaultId::kJointJump;
  // A controller that stands has an attitude of its own, and rates are all that it must have.
  if (!imu.rates_fit() || !(imu.attitude_fits() || standing())) return FaultId::kAttitude;
  // Between the last report and this one nobody was there to command. Who has a link knows better
  // whether it was the robot that was silent: lose().
  if (active() && !arming.told() && clock.gap() > kAwayTime) return FaultId::kStaleTick;
  // Who lies need not act upon it: sensors that have stopped, not those that measure seldom.
  const bool old = active() ? repeated.too_old() : repeated.stopped();
  return old ? FaultId::kFrozen : FaultId::kNone;
}

}  // namespace surefoot
