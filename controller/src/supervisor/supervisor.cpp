// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/supervisor.hpp"

#include "common/text.hpp"
#include "supervisor/supervisor_impl.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

namespace {
constexpr double kUnlimited = std::numeric_limits<double>::infinity();
}

// The range of power_level is that of the SDK's PowerProtect, and 0, which switches the protection
// off. Temperatures have the range of LowState (int8 [deg C]). The other ranges exclude values that
// make no sense.
void SupervisorOptions::validate() const {
  const auto expect = [](const char* name, double got, double lower, double upper) {
    if (got >= lower && got <= upper) return;
    throw Error(std::string("option '") + name + "' out of range: got " + to_text(got) +
                ", expected " + to_text(lower) + " .. " + to_text(upper));
  };
  expect("power_level", power_level, 0.0, 10.0);
  expect("arming_time", arming_time, 0.0, 60.0);
  expect("temperature_warning", temperature_warning, 0.0, 126.0);
  expect("temperature_stop", temperature_stop, temperature_warning + 1.0, 127.0);
  expect("battery_low", battery_low, 0.0, 100.0);
  expect("payload_limit", payload_limit, 0.0, kUnlimited);
  expect("operator_timeout", operator_timeout, 0.01, kUnlimited);
  expect("joint_margin", joint_margin, -0.5, 0.5);
  WalkOptions{stand, velocity_timeout}.validate();
}

Supervisor::Supervisor(const Robot& robot) : Supervisor(robot, robot.config().gains) {}
Supervisor::Supervisor(const Robot& robot, const Gains& gains, const SupervisorOptions& options)
    : impl_(std::make_unique<Impl>(robot, gains, options)) {}
Supervisor::~Supervisor() = default;
Supervisor::Supervisor(Supervisor&&) noexcept = default;

const LowCmd& Supervisor::update(const LowState& low_state) noexcept {
  return impl_->tick(low_state);
}
const LowCmd& Supervisor::update_without_state(double age) noexcept {
  return impl_->update_without_state(age);
}
void Supervisor::report_link_lost() noexcept { impl_->report_link_lost(); }
void Supervisor::report_conflict(bool present) noexcept { impl_->arming.set_conflict(present); }
void Supervisor::count_samples(double received, double missing) noexcept {
  impl_->arming.add_link_counts(received, missing);
}
RequestStatus Supervisor::request(Mode mode) noexcept { return impl_->requests.request_mode(mode); }
RequestStatus Supervisor::arm() noexcept { return impl_->requests.request_arming(); }
void Supervisor::stop() noexcept { impl_->requests.stop(); }

Mode Supervisor::mode() const noexcept { return impl_->requests.context().mode; }
bool Supervisor::armed() const noexcept { return impl_->requests.context().armed; }
FaultId Supervisor::damping_fault() const noexcept { return impl_->latched_fault; }
ArmingReport Supervisor::arming() const noexcept { return impl_->arming_report.read(); }
FaultReport Supervisor::faults() const noexcept { return impl_->faults.read(); }
void Supervisor::heartbeat() noexcept { ++impl_->heartbeats; }
double Supervisor::rise_progress() const noexcept { return impl_->published_progress; }
double Supervisor::rise_time() const noexcept { return impl_->plan.time; }
bool Supervisor::fading() const noexcept { return impl_->requests.context().fading; }
RiseStage Supervisor::rise_stage() const noexcept { return impl_->published_stage; }
bool Supervisor::rise_failed() const noexcept { return impl_->rise_abandoned; }

void Supervisor::set_body_reference(const BodyReference& target) noexcept {
  impl_->controller.set_body_reference(target);
}
void Supervisor::set_gains(const Gains& gains) { impl_->set_gains(gains); }
void Supervisor::set_velocity(const WalkVelocity& velocity) noexcept {
  impl_->set_velocity(velocity);
}
void Supervisor::set_gait(Gait gait) noexcept { impl_->set_gait(gait); }
Gait Supervisor::gait() const noexcept { return impl_->gait; }
bool Supervisor::stopping() const noexcept { return impl_->requests.context().stopping; }
const WalkController& Supervisor::controller() const noexcept { return impl_->controller; }
bool Supervisor::command_is_fresh() const noexcept { return impl_->fresh; }
double Supervisor::measured_power() const noexcept { return impl_->safety.power(); }

const char* to_string(Mode mode) noexcept {
  constexpr std::array<const char*, 6> names = {"passive", "rise", "stand",
                                                "walk",    "sit",  "damping"};
  return names[static_cast<int>(mode)];
}

const char* to_string(RiseStage stage) noexcept {
  constexpr std::array<const char*, 5> names = {"hold_legs", "fold", "weigh", "press", "up"};
  return names[static_cast<int>(stage)];
}

const char* to_string(Start start) noexcept {
  return start == Start::kStanding ? "standing" : "lying";
}

const char* to_string(RequestStatus status) noexcept {
  constexpr std::array<const char*, 8> names = {"accepted",  "no_state",   "not_armed",
                                                "not_ready", "latched",    "out_of_order",
                                                "busy",      "cannot_walk"};
  return names[static_cast<int>(status)];
}

}  // namespace surefoot
