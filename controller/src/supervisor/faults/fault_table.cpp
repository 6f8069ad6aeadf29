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
    "by itself, or with arm() if the estimator found it while the robot stood";

// Rows in the order of FaultId: fault, reaction, detection time, how the fault ends, description.
// Detection times [s] are upper limits that `surefoot faults` checks in every cell. 0.002 is one
// period at 500 Hz; 0.020 is kStaleTime. Each other value is the time that the detector needs plus
// a margin.
constexpr std::array<FaultInfo, kFaults - 1> kRows = {{
    {FaultId::kStop, kDamp, 0.002, kNeedsArm,
     "operator stop: stop() from any thread, or x + Enter in surefoot run; the motors damp "
     "until arm()"},
    {FaultId::kButton, kDamp, 0.002, kNeedsArm,
     "button B of the remote is pressed; the motors damp until arm()"},
    {FaultId::kStateNotFinite, kDamp, 0.020, kNeedsArm,
     "a LowState field is NaN, infinite or beyond 1e4 in its unit; the last good command is "
     "repeated for 10 ms, then the motors damp until arm()"},
    {FaultId::kStateImplausible, kDamp, 0.020, kNeedsArm,
     "a LowState field is beyond what the robot can do or its sensor can measure; the last "
     "good command is repeated for 10 ms, then the motors damp until arm()"},
    {FaultId::kStaleTick, kDamp, 0.020, kNeedsArm,
     "LowState.tick stands still, runs backwards or jumps; the last good command is repeated "
     "for 10 ms, then the motors damp until arm(); after a gap of more than 100 ms, in which "
     "the robot damps on its own, they damp at once"},
    {FaultId::kFrozen, kDamp, 0.020, kNeedsArm,
     "IMU and joint values repeat byte for byte for 10 ms while the tick advances; the last "
     "good command is repeated for 10 ms, then the motors damp until arm()"},
    {FaultId::kLoss, kWatch, 1.0, kClearsByItself,
     "more than 5 % of the samples of the last second are missing; no reaction, check the "
     "network"},
    {FaultId::kJointJump, kDamp, 0.020, kNeedsArm,
     "a joint angle jumps further than its velocity explains; the last good command is "
     "repeated for 10 ms, then the motors damp until arm()"},
    {FaultId::kEncoder, kDamp, 0.060, kNeedsArm,
     "the angles and velocities of one leg repeat bit for bit, although the repeated velocity "
     "amounts to 0.01 rad of motion: an encoder has stopped; the motors damp until arm() (the "
     "stated time holds from 0.2 rad/s on)"},
    {FaultId::kClock, kDamp, 0.200, kNeedsArm,
     "the joints move less than 0.7 of what their velocities predict by the robot's clock: "
     "the clock is too fast, and so is every timed motion; the motors damp until arm()",
     "a clock is a fault too if the joints move more than 1.4 of what their velocities predict: it "
     "is too slow, and the steps come late",
     0.3},
    {FaultId::kQuaternion, kDegrade, 0.1, kClearsByItself,
     "the quaternion is not of unit length, or contradicts the gyroscope and the legs; a "
     "standing robot continues without it"},
    {FaultId::kAttitude, kDamp, 0.020, kNeedsArm,
     "the gyroscope jumps, or the robot is not standing and its attitude is missing or jumps "
     "against the gyroscope; the last good command is repeated for 10 ms, then the motors "
     "damp until arm()"},
    {FaultId::kGyroscope, kSit, 1.0, kClearsByItselfOrArm,
     "the gyroscope is zero, constant or clipped for 50 ms, or differs from the rate of the "
     "attitude by 0.08 rad/s over half a second (plus 5 % of the rate while not standing); "
     "the robot sits down"},
    {FaultId::kAccelerometer, kDegrade, 0.5, kClearsByItself,
     "the accelerometer is zero, constant, saturated or contradicts the other sensors; "
     "attitude and velocity come from those; a robot that is rising sits down again"},
    {FaultId::kFootForce, kDegrade, 2.0, kClearsByItself,
     "a foot force sensor is stuck, saturated or contradicts the other sensors; contact comes "
     "from those"},
    {FaultId::kSlip, kDegrade, 0.1, kClearsByItself,
     "a stance foot slips; the controller assumes less friction",
     "the foot has slipped for 20 ms of one stance; a new stance begins without slip; the robot "
     "walks on"},
    {FaultId::kLifted, kDegrade, 0.1, kClearsByItself,
     "no foot is loaded; the controller holds the pose softly",
     "no foot is loaded for 0.2 s, longer than a flight of the trot; the robot stops walking, and "
     "stands on softly; the mode walk must be requested again",
     0.25, true},
    {FaultId::kPayload, kSit, 2.0, kNeedsArm,
     "the payload is above the option payload_limit; the robot sits down and does not rise "
     "before arm()"},
    {FaultId::kTilt, kDamp, 0.010, kNeedsArm,
     "the body is tilted too far, or will be within 0.1 s; the motors damp until arm()"},
    {FaultId::kMotorMode, kDamp, 0.006, kNeedsArm,
     "a motor is not in servo mode in two samples; the motors damp until arm(), unless the "
     "robot can stand without that leg: see leg_lost"},
    {FaultId::kMotorWeak, kDamp, 0.15, kNeedsArm,
     "a motor's torque is missing or far from its command for 50 ms; the motors damp until "
     "arm(), unless the robot can stand without that leg: see leg_lost"},
    {FaultId::kLegLost, kDegrade, 0.15, kNeedsArm,
     "motor_mode or motor_weak in one leg of a standing robot whose capture point is over the "
     "other three feet; the robot stands on those until arm(); if a second leg fails, the "
     "motors damp",
     "the robot puts its feet down within 0.3 s and stands on three; the mode walk is refused "
     "until "
     "arm()",
     0.0, true},
    {FaultId::kOverridden, kDamp, 0.2, kNeedsArm,
     "torques in several legs do not follow their commands: another program, such as the "
     "sport mode, commands the robot too; the motors damp until arm(); stop the other program "
     "first"},
    {FaultId::kWiring, kDamp, 15.0, kNeedsArm,
     "lying: the body rolls over its folding legs although they were released twice, a leg "
     "does not weigh on its hip as it must, or the nose does not go down when the rear legs "
     "press; legs are swapped, a motor turns the wrong way, or the robot does not lie free on "
     "the ground; the motors damp until arm() (found within 4 s after all legs are folded; "
     "swapped legs may take longer to fold)"},
    {FaultId::kWrongRobot, kDamp, 15.0, kNeedsArm,
     "lying: the legs weigh less than 0.6 or more than 1.5 times what the model says, or no "
     "leg can move because it is held or too heavy; the motors damp until arm(); check which "
     "robot was chosen"},
    {FaultId::kTemperature, kSit, 2.0, kClearsByItself,
     "a motor is at temperature_stop; the robot sits down; torque limits already fall from "
     "temperature_warning on"},
    {FaultId::kJointStop, kDamp, 0.006, kNeedsArm,
     "a joint is outside its limits by more than joint_margin permits in three samples; the "
     "motors damp until arm()"},
    {FaultId::kPower, kDamp, 0.014, kNeedsArm,
     "the motors took more than the option power_level in a net six samples (the SDK's "
     "PowerProtect rule); the motors damp until arm()"},
    {FaultId::kTorqueRate, kWatch, 0.010, kClearsByItself,
     "the controller's torques have been rate-limited, to 9.5 % of their limits in 2 ms, "
     "for 8 ms; no other reaction",
     "they have been limited for 300 ms: each step limits them for a while", 0.302},
    {FaultId::kProgram, kWatch, 0.002, kClearsByItself,
     "the controller's QP was not solved at the first attempt; a cold solve replaces it, "
     "or fallback commands for at most 10 ms"},
    {FaultId::kController, kDamp, 0.020, kNeedsArm,
     "the controller has had no usable solution for more than 10 ms; the motors damp "
     "until arm()"},
    {FaultId::kHanging, kSit, 0.5, kClearsByItself,
     "the legs carry less than 0.35 of the weight at the end of a rise: the robot hangs or is "
     "held; the robot sits down"},
    {FaultId::kBattery, kSit, 2.0, kClearsByItself,
     "the battery charge is below the option battery_low; the robot sits down (not judged if "
     "no battery data comes)"},
    {FaultId::kOperator, kSit, 0.1, kClearsByItself,
     "no heartbeat() from the operator's program for the option operator_timeout; the robot "
     "sits down"},
    {FaultId::kLink, kDamp, 0.020, kNeedsArm,
     "no LowState comes, the robot has restarted, or this program was paused; the last good "
     "command is repeated for 10 ms, then the motors damp until arm()"},
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

FaultId FaultReport::stops_walking() const noexcept {
  for (const FaultInfo& info : kRows) {
    if (info.stops_walking && has(info.id)) return info.id;
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
