// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/fault.hpp"

namespace surefoot {

namespace {

constexpr auto kWatch = FaultReaction::kWatch;
constexpr auto kDegrade = FaultReaction::kDegrade;
constexpr auto kSit = FaultReaction::kSit;
constexpr auto kDamp = FaultReaction::kDamp;

constexpr std::string_view kNeedsArm = "arm()";
constexpr std::string_view kClearsByItself = "by itself";
constexpr std::string_view kClearsByItselfOrArm =
    "by itself, or arm() where legs that stood told it";

constexpr std::array<FaultInfo, kFaults - 1> kRows = {{
    {FaultId::kStop, kDamp, 0.002, kNeedsArm,
     "an operator's stop: stop() from any thread, x + Enter in surefoot run"},
    {FaultId::kButton, kDamp, 0.002, kNeedsArm, "B on the remote"},
    {FaultId::kStateNotFinite, kDamp, 0.020, kNeedsArm,
     "a NaN, an infinity, more than 1e4 in any unit: the last good command for 10 ms, then "
     "damping"},
    {FaultId::kStateImplausible, kDamp, 0.020, kNeedsArm,
     "beyond what the robot can do or measure: the last good command for 10 ms, then damping"},
    {FaultId::kStaleTick, kDamp, 0.020, kNeedsArm,
     "tick does not advance: the last good command for 10 ms, then damping; or it leaps by more "
     "than "
     "100 ms, in which robots damp by themselves"},
    {FaultId::kFrozen, kDamp, 0.020, kNeedsArm,
     "IMU and joints repeat themselves byte by byte for 10 ms: held as long, then damping"},
    {FaultId::kLoss, kWatch, 1.0, kClearsByItself,
     "more than 5 % of the reports of a second are missing"},
    {FaultId::kJointJump, kDamp, 0.020, kNeedsArm,
     "an angle jumps more than its speed explains: held for 10 ms, then damping"},
    {FaultId::kEncoder, kDamp, 0.060, kNeedsArm,
     "a leg's angles and speeds repeat themselves bit by bit, while a speed of theirs above 0.2 "
     "rad/s "
     "says that it moves; slower, once that makes 0.01 rad"},
    {FaultId::kClock, kDamp, 0.200, kNeedsArm,
     "joints that move go less than 0.7 of the way that their speeds make by the robot's clock: it "
     "goes too fast, and what goes by it with it"},
    {FaultId::kQuaternion, kDegrade, 0.1, kClearsByItself,
     "no unit length, or contradicted by gyroscope and legs: standing goes on without it"},
    {FaultId::kAttitude, kDamp, 0.020, kNeedsArm,
     "attitude and gyroscope jump against each other, or it rises or sits without an attitude: "
     "held for 10 ms, then damping"},
    {FaultId::kGyroscope, kSit, 1.0, kClearsByItselfOrArm,
     "zero, constant, clipped for 50 ms, or off the attitude's rate by 0.08 rad/s, and a twentieth "
     "of it where the robot does not stand, for half a second"},
    {FaultId::kAccelerometer, kDegrade, 0.5, kClearsByItself,
     "zero, constant, saturated or contradicted: attitude and velocity from the rest; who has not "
     "begun to stand sits down"},
    {FaultId::kFootForce, kDegrade, 2.0, kClearsByItself,
     "a foot's sensor is stuck, saturated or contradicted: contact from the rest"},
    {FaultId::kSlip, kDegrade, 0.1, kClearsByItself,
     "a standing foot slips: less friction is counted on"},
    {FaultId::kLifted, kDegrade, 0.1, kClearsByItself,
     "no foot bears anything: the pose is held softly"},
    {FaultId::kPayload, kSit, 2.0, kNeedsArm, "more than the option payload_limit"},
    {FaultId::kTilt, kDamp, 0.010, kNeedsArm,
     "the body is tilted too far, or will be in a tenth of a second"},
    {FaultId::kMotorMode, kDamp, 0.006, kNeedsArm, "a motor reports another mode than servo twice"},
    {FaultId::kMotorWeak, kDamp, 0.15, kNeedsArm,
     "a motor's torque is far off what it is told, or none, for 50 ms"},
    {FaultId::kLegLost, kDegrade, 0.15, kNeedsArm,
     "motor_mode or motor_weak in one leg of a robot that stands, its centre of mass over the "
     "other three feet: that leg is given up; a second is not"},
    {FaultId::kOverridden, kDamp, 0.2, kNeedsArm,
     "the same in several legs at once: another program commands the robot, such as the sport "
     "mode"},
    {FaultId::kWiring, kDamp, 15.0, kNeedsArm,
     "lying: the body rolls over the legs that fold, though they were let go of; or a leg does not "
     "hang on its hip as it must, or the rear legs press and the nose does not go down: legs are "
     "swapped, a motor turns the other way, or it does not lie free on the ground; 4 s once all "
     "legs are "
     "folded, which swapped ones may not be for longer"},
    {FaultId::kWrongRobot, kDamp, 15.0, kNeedsArm,
     "lying: its legs weigh less than 0.6 or more than 1.5 times what the model says; or none can "
     "be moved, held or too heavy for its springs"},
    {FaultId::kTemperature, kSit, 2.0, kClearsByItself,
     "torque limits fall from temperature_warning on; the robot sits down at temperature_stop"},
    {FaultId::kJointStop, kDamp, 0.006, kNeedsArm, "a joint is beyond its stop in three reports"},
    {FaultId::kPower, kDamp, 0.014, kNeedsArm,
     "joints took more than the option power_level for six reports net: PowerProtect's rule"},
    {FaultId::kTorqueRate, kWatch, 0.010, kClearsByItself,
     "the StandController's torques are held back, to changes of 9.5 % of their limits in 2 ms, "
     "for 8 ms"},
    {FaultId::kProgram, kWatch, 0.002, kClearsByItself,
     "the StandController has no solution at once: it is sought anew, or bridged for at most 10 "
     "ms"},
    {FaultId::kController, kDamp, 0.020, kNeedsArm, "no usable solution for longer than 10 ms"},
    {FaultId::kHanging, kSit, 0.5, kClearsByItself,
     "up, and the legs bear less than a third of the weight"},
    {FaultId::kBattery, kSit, 2.0, kClearsByItself,
     "charge below the option battery_low, where it is told"},
    {FaultId::kOperator, kSit, 0.1, kClearsByItself,
     "the operator's program is silent: no heartbeat() for the option operator_timeout"},
    {FaultId::kLink, kDamp, 0.020, kNeedsArm,
     "the robot is not heard, or began anew, or this program stood still: the last good command "
     "for "
     "10 ms, then damping"},
}};

constexpr bool ordered() {
  for (int i = 0; i < kFaults - 1; ++i) {
    if (static_cast<int>(kRows[i].id) != i + 1) return false;
  }
  return true;
}
static_assert(ordered());

}  // namespace

const std::array<FaultInfo, kFaults - 1>& fault_table() noexcept { return kRows; }

FaultId FaultReport::first_active(FaultReaction reaction, FaultId except) const noexcept {
  for (const FaultInfo& info : kRows) {
    if (info.reaction == reaction && info.id != except && has(info.id)) return info.id;
  }
  return FaultId::kNone;
}

FaultInfo fault_info(FaultId id) noexcept {
  const int row = static_cast<int>(id) - 1;
  return row >= 0 && row < kFaults - 1 ? kRows[row] : FaultInfo();
}

const char* to_string(FaultId id) noexcept {
  constexpr std::array<const char*, kFaults> names = {"none",
                                                      "stop",
                                                      "button",
                                                      "state_not_finite",
                                                      "state_implausible",
                                                      "stale_tick",
                                                      "frozen",
                                                      "loss",
                                                      "joint_jump",
                                                      "encoder",
                                                      "clock",
                                                      "quaternion",
                                                      "attitude",
                                                      "gyroscope",
                                                      "accelerometer",
                                                      "foot_force",
                                                      "slip",
                                                      "lifted",
                                                      "payload",
                                                      "tilt",
                                                      "motor_mode",
                                                      "motor_weak",
                                                      "leg_lost",
                                                      "overridden",
                                                      "wiring",
                                                      "wrong_robot",
                                                      "temperature",
                                                      "joint_stop",
                                                      "power",
                                                      "torque_rate",
                                                      "program",
                                                      "controller",
                                                      "hanging",
                                                      "battery",
                                                      "operator",
                                                      "link"};
  return names[static_cast<int>(id)];
}

const char* to_string(FaultReaction reaction) noexcept {
  constexpr std::array<const char*, 5> names = {"none", "watch", "degrade", "sit", "damp"};
  return names[static_cast<int>(reaction)];
}

}  // namespace surefoot
