// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <string>
#include <vector>

#include "common/text.hpp"
#include "surefoot/error.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

namespace {

using G = Gains;
constexpr std::string_view kBody = "Body";
constexpr std::string_view kFeet = "Feet";
constexpr std::string_view kJoints = "Joints";
constexpr std::string_view kQp = "Quadratic program (QP)";
constexpr std::string_view kReference = "Body reference";
constexpr std::string_view kWalking = "Walking";
constexpr std::string_view kEstimator = "Estimator";
constexpr std::string_view kCommand = "Command";
constexpr GainInfo kRows[] = {
    {kBody, "com_kp_horizontal", "1/s^2", 0, 2000, &G::com_kp_horizontal,
     "horizontal stiffness of the centre of mass, per unit mass"},
    {kBody, "com_kd_horizontal", "1/s", 0, 200, &G::com_kd_horizontal,
     "horizontal damping of the centre of mass, per unit mass"},
    {kBody, "com_kp_vertical", "1/s^2", 0, 2000, &G::com_kp_vertical,
     "vertical stiffness of the centre of mass, per unit mass"},
    {kBody, "com_kd_vertical", "1/s", 0, 200, &G::com_kd_vertical,
     "vertical damping of the centre of mass, per unit mass"},
    {kBody, "base_kp_tilt", "1/s^2", 0, 2000, &G::base_kp_tilt, "roll and pitch stiffness"},
    {kBody, "base_kd_tilt", "1/s", 0, 200, &G::base_kd_tilt, "roll and pitch damping"},
    {kBody, "base_kp_yaw", "1/s^2", 0, 2000, &G::base_kp_yaw, "yaw stiffness"},
    {kBody, "base_kd_yaw", "1/s", 0, 200, &G::base_kd_yaw, "yaw damping"},
    {kFeet, "foot_kp", "1/s^2", 0, 5000, &G::foot_kp,
     "stiffness of a foot about its reference position"},
    {kFeet, "foot_kd", "1/s", 0, 500, &G::foot_kd, "damping of the velocity of a foot"},
    {kJoints, "posture_kp", "1/s^2", 0, 5000, &G::posture_kp, "stiffness of the posture task"},
    {kJoints, "posture_kd", "1/s", 0, 500, &G::posture_kd, "damping of the posture task"},
    {kJoints, "joint_limit_rate", "1/s", 1, 200, &G::joint_limit_rate,
     "greatest speed of a joint towards its position limit, per distance left"},
    {kJoints, "joint_limit_margin", "rad", 0, 0.5, &G::joint_limit_margin,
     "distance kept from the position limits"},
    {kQp, "weight_com_horizontal", "1", 1e-4, 1e4, &G::weight_com_horizontal,
     "weight of the horizontal acceleration of the centre of mass"},
    {kQp, "weight_com_vertical", "1", 1e-4, 1e4, &G::weight_com_vertical,
     "weight of the vertical acceleration of the centre of mass"},
    {kQp, "weight_base_tilt", "1", 1e-4, 1e4, &G::weight_base_tilt,
     "weight of the roll and pitch acceleration"},
    {kQp, "weight_base_yaw", "1", 1e-4, 1e4, &G::weight_base_yaw, "weight of the yaw acceleration"},
    {kQp, "weight_momentum", "1", 0, 1e4, &G::weight_momentum,
     "weight of the angular momentum about the centre of mass"},
    {kQp, "momentum_kd", "1/s", 0, 200, &G::momentum_kd, "damping of the angular momentum"},
    {kQp, "weight_posture", "1", 0, 1e2, &G::weight_posture,
     "weight of the posture task for all joints"},
    {kQp, "weight_posture_free", "1", 1e-4, 1e2, &G::weight_posture_free,
     "the same for joints that no foot determines: further joints, legs near a singularity"},
    {kQp, "weight_foot_soft", "1", 1e-2, 1e3, &G::weight_foot_soft,
     "weight of the acceleration of a foot whose leg is near a singularity"},
    {kQp, "weight_force", "1", 1e-6, 1e2, &G::weight_force,
     "weight of the difference from the even forces"},
    {kQp, "weight_smooth", "1", 0, 1e2, &G::weight_smooth,
     "weight of the difference from the forces of the last tick"},
    {kQp, "penalty_torque", "1", 1, 1e4, &G::penalty_torque,
     "penalty for torque above the motor limit"},
    {kQp, "penalty_joint_limit", "1", 0.1, 1e4, &G::penalty_joint_limit,
     "penalty for violating a joint's position or velocity limit"},
    {kQp, "penalty_hold_down", "1", 1e-3, 1e3, &G::penalty_hold_down,
     "penalty for a normal force of a stance foot below hold_down"},
    {kQp, "hold_down", "m g", 0, 0.2, &G::hold_down,
     "hold-down: smallest normal force of a stance foot in contact"},
    {kQp, "edge_margin", "m", 1e-3, 1, &G::edge_margin,
     "distance of the capture point from the support edge below which balance has priority"},
    {kQp, "edge_tilt", "1", 0.01, 1, &G::edge_tilt,
     "factor on weight_base_tilt at the support edge, where turning the body helps to balance"},
    {kQp, "edge_height", "1", 0.01, 1, &G::edge_height,
     "factor on weight_com_vertical at the support edge"},
    {kQp, "edge_load", "m g", 0, 0.9, &G::edge_load,
     "least planned load of all feet together at the support edge, because a falling body cannot "
     "brake a push; 0.35 less away from the edge"},
    {kQp, "edge_rise", "m/s", 0.1, 100, &G::edge_rise,
     "upward speed of the body at which the desired tilt acceleration is zero (smaller from 3/8 of "
     "it on), because turning back pushes the body further up; 100: no limit in practice"},
    {kQp, "force_max_contact", "m g", 0.3, 10, &G::force_max_contact,
     "greatest normal force of a foot in contact"},
    {kQp, "force_lost_contact", "m g", 0.05, 1, &G::force_lost_contact,
     "greatest normal force of a stance foot that has lost contact"},
    {kQp, "share_lost_contact", "1", 0.01, 1, &G::share_lost_contact,
     "share of the even load planned for a stance foot that has lost contact"},
    {kReference, "reference_speed", "m/s", 1e-3, 2, &G::reference_speed,
     "greatest speed of the body reference"},
    {kReference, "reference_turn_speed", "rad/s", 1e-3, 10, &G::reference_turn_speed,
     "greatest angular speed of the body reference"},
    {kReference, "reference_acceleration", "m/s^2", 1e-2, 50, &G::reference_acceleration,
     "greatest acceleration of the body reference, also when it stops at the support edge"},
    {kReference, "reference_turn_acceleration", "rad/s^2", 1e-1, 200,
     &G::reference_turn_acceleration, "greatest angular acceleration of the body reference"},
    {kReference, "reference_time", "s", 0.01, 5, &G::reference_time,
     "time constant with which the body reference approaches its target"},
    {kReference, "reach_joint_margin", "rad", 0, 0.5, &G::reach_joint_margin,
     "distance from the joint limits at which the body reference stops"},
    {kReference, "reach_support_margin", "m", 0, 0.5, &G::reach_support_margin,
     "distance of the centre of mass from the support edge at which the body reference stops"},
    {kReference, "reach_foot_depth", "m", 0, 0.5, &G::reach_foot_depth,
     "distance of a foot below its hip axis at which the body reference stops; at 0 the leg is "
     "singular"},
    {kWalking, "gait_period", "sqrt(h/g)", 1, 10, &G::gait_period,
     "longest period of the gait; h: height of the centre of mass above the feet, standing pose"},
    {kWalking, "gait_duty", "1", 0.3, 0.9, &G::gait_duty,
     "greatest share of the period in which a foot stands"},
    {kWalking, "gait_stance_travel", "h", 0.1, 2, &G::gait_stance_travel,
     "longest distance that the body moves while a foot stands; at higher speed the period is "
     "shorter"},
    {kWalking, "gait_swing_speed", "h corner_speed", 0.1, 10, &G::gait_swing_speed,
     "greatest speed of a swing foot past the body; at higher speed the duty is smaller"},
    {kWalking, "foothold_feedback", "sqrt(h/g)", 0, 2, &G::foothold_feedback,
     "distance of a foothold ahead, per velocity beyond the commanded one; 1: capture point"},
    {kWalking, "recovery_margin", "h", -10, 0.5, &G::recovery_margin,
     "capture margin below which a standing robot that has lost two contacts steps; with all "
     "contacts it steps below 0, or below this gain if it is negative; -10: never"},
    {kWalking, "swing_height", "h", 0.02, 0.8, &G::swing_height,
     "height to which a swing foot rises"},
    {kWalking, "swing_landing_speed", "sqrt(g h)", 0, 1, &G::swing_landing_speed,
     "downward speed at which a foot lands"},
    {kWalking, "walk_weight_base_rotation", "1", 1e-4, 1e4, &G::walk_weight_base_rotation,
     "weight of roll, pitch and yaw acceleration while the robot steps"},
    {kWalking, "walk_joint_limit_rate", "1/s", 1, 200, &G::walk_joint_limit_rate,
     "joint_limit_rate of a walking robot"},
    {kWalking, "walk_hold_down", "m g", 0, 0.2, &G::walk_hold_down,
     "hold_down while one foot of a walking robot swings"},
    {kWalking, "walk_acceleration", "g", 0.01, 2, &G::walk_acceleration,
     "greatest acceleration of the commanded velocity"},
    {kWalking, "walk_turn_acceleration", "g/h", 0.01, 2, &G::walk_turn_acceleration,
     "greatest acceleration of the commanded yaw rate"},
    {kWalking, "walk_power_rest", "m g sqrt(g h)", 0, 10, &G::walk_power_rest,
     "power peaks of a trot in place; with walk_power_rise and ControllerOptions::power_limit they "
     "limit the commanded velocity"},
    {kWalking, "walk_power_rise", "m g sqrt(g h)", 0.1, 100, &G::walk_power_rise,
     "additional power peaks at a speed of sqrt(g h); they grow with the cube of the speed"},
    {kWalking, "walk_speed_forward", "sqrt(g h)", 0, 3, &G::walk_speed_forward,
     "greatest commanded speed forward"},
    {kWalking, "walk_speed_backward", "sqrt(g h)", 0, 3, &G::walk_speed_backward,
     "greatest commanded speed backward"},
    {kWalking, "walk_speed_sideways", "sqrt(g h)", 0, 3, &G::walk_speed_sideways,
     "greatest commanded speed to the side"},
    {kWalking, "walk_turn_speed", "sqrt(g/h)", 0, 3, &G::walk_turn_speed,
     "greatest commanded yaw rate"},
    {kWalking, "walk_gait_period", "sqrt(h/g)", 2, 40, &G::walk_gait_period,
     "gait_period of the gait walk"},
    {kWalking, "walk_gait_duty", "1", 0.75, 0.95, &G::walk_gait_duty,
     "share of the period in which a foot stands, gait walk"},
    {kWalking, "walk_gait_margin", "h", 0, 0.3, &G::walk_gait_margin,
     "distance of the zero-moment point from the edges of the support triangle, gait walk"},
    {kWalking, "walk_gait_swing_height", "h", 0.02, 0.8, &G::walk_gait_swing_height,
     "swing_height of the gait walk"},
    {kWalking, "walk_gait_speed", "sqrt(g h)", 0, 1, &G::walk_gait_speed,
     "greatest commanded speed, gait walk"},
    {kWalking, "walk_gait_turn_speed", "sqrt(g/h)", 0, 1, &G::walk_gait_turn_speed,
     "greatest commanded yaw rate, gait walk"},
    {kEstimator, "noise_gyroscope", "rad/s", 1e-6, 10, &G::noise_gyroscope,
     "gyroscope noise, standard deviation of a sample, until it has been measured"},
    {kEstimator, "noise_accelerometer", "m/s^2", 1e-4, 100, &G::noise_accelerometer,
     "accelerometer noise, standard deviation of a sample, until it has been measured"},
    {kEstimator, "gyroscope_drift", "rad/s/sqrt(s)", 0, 1, &G::gyroscope_drift,
     "random walk of the gyroscope bias"},
    {kEstimator, "accelerometer_drift", "m/s^2/sqrt(s)", 0, 10, &G::accelerometer_drift,
     "random walk of the accelerometer bias"},
    {kEstimator, "accelerometer_drift_vertical", "m/s^2/sqrt(s)", 0, 10,
     &G::accelerometer_drift_vertical,
     "additional random walk of the accelerometer bias along the vertical"},
    {kEstimator, "start_tilt", "rad", 1e-4, 3, &G::start_tilt,
     "greatest initial standard deviation of the tilt"},
    {kEstimator, "start_velocity", "m/s", 1e-4, 10, &G::start_velocity,
     "initial standard deviation of the velocity"},
    {kEstimator, "start_gyroscope_bias", "rad/s", 1e-6, 1, &G::start_gyroscope_bias,
     "initial standard deviation of the gyroscope bias"},
    {kEstimator, "start_accelerometer_bias", "m/s^2", 1e-6, 5, &G::start_accelerometer_bias,
     "initial and long-term standard deviation of the accelerometer bias"},
    {kEstimator, "noise_foot_position", "m", 1e-6, 1, &G::noise_foot_position,
     "noise of a foot position from the joint angles, until it has been measured"},
    {kEstimator, "noise_foot_slip", "m/s", 1e-6, 10, &G::noise_foot_slip,
     "assumed velocity noise of a stance foot"},
    {kEstimator, "noise_foot_motion", "1", 0, 10, &G::noise_foot_motion,
     "additional velocity noise of a foot, as a share of its speed relative to the base"},
    {kEstimator, "leg_scale", "1", 0, 1, &G::leg_scale,
     "position error per distance travelled, from leg lengths, foot radii and slips"},
    {kEstimator, "gate_foot", "sigma", 1, 100, &G::gate_foot,
     "innovation gate of a foot: larger innovations get less weight, none beyond 5 times the gate"},
    {kEstimator, "contact_force_on", "m g", 0.001, 0.5, &G::contact_force_on,
     "load above which a contact begins"},
    {kEstimator, "contact_force_off", "m g", 0.001, 0.5, &G::contact_force_off,
     "load below which a contact ends"},
    {kEstimator, "contact_force_width", "m g", 0.001, 0.5, &G::contact_force_width,
     "distance of a load from these thresholds at which it is clear evidence"},
    {kEstimator, "contact_dwell", "s", 0, 0.5, &G::contact_dwell,
     "time in which clear evidence changes the contact confidence from 0 to 1"},
    {kEstimator, "slip_speed", "m/s", 0.01, 10, &G::slip_speed,
     "speed above that of the slowest loaded foot at which a loaded foot slips"},
    {kEstimator, "slip_friction", "1", 0.1, 1, &G::slip_friction,
     "factor on the friction coefficient of a slipping foot"},
    {kEstimator, "payload_time", "s", 0.05, 100, &G::payload_time,
     "time constant of the sustained external wrench, which the joint torques do not explain"},
    {kEstimator, "payload_max", "m g", 0, 5, &G::payload_max, "greatest sustained external force"},
    {kEstimator, "push_time", "s", 0.001, 10, &G::push_time,
     "time constant of the push, which the commands do not explain; down to 3/8 of it for large "
     "horizontal changes"},
    {kEstimator, "push_dead_band", "m/s^2", 0, 100, &G::push_dead_band,
     "dead band of the push: less unexplained acceleration counts as noise"},
    {kEstimator, "push_max", "m/s^2", 0, 100, &G::push_max, "greatest acceleration of a push"},
    {kEstimator, "push_resist", "1", 0, 1, &G::push_resist,
     "share of the external force that the feet counteract at once"},
    {kCommand, "fall_tilt", "rad", 0.1, 1.6, &G::fall_tilt,
     "tilt of the base above which the motors damp"},
    {kCommand, "damping_kd", "N.m.s/rad", 0.0625, 50, &G::damping_kd,
     "Kd of the motors in damping"},
    {kCommand, "fold_wait", "s", 0, 3, &G::fold_wait,
     "longest time for which one diagonal pair of legs waits for the other to fold, if a lying "
     "body leans; 0: all legs fold at once"},
};
// A member of Gains without a row would be neither saved nor validated.
static_assert(sizeof(Gains) == std::size(kRows) * sizeof(double), "each gain has a row");

std::vector<std::string> gain_names() {
  std::vector<std::string> names;
  for (const GainInfo& info : kRows) names.emplace_back(info.name);
  return names;
}

const GainInfo& find_gain(std::string_view name) {
  for (const GainInfo& info : kRows) {
    if (info.name == name) return info;
  }
  throw Error("unknown gain: got '" + std::string(name) + "'" + suggestion(name, gain_names()) +
              "; valid names: " + join(gain_names()));
}

bool in_range(const GainInfo& info, double value) noexcept {
  return std::isfinite(value) && value >= info.minimum && value <= info.maximum;
}

void check_gain(const GainInfo& info, double value) {
  if (in_range(info, value)) return;
  throw Error("gain '" + std::string(info.name) + "' out of range: got " + to_text(value) +
              ", expected " + to_text(info.minimum) + " .. " + to_text(info.maximum) + " [" +
              std::string(info.unit) + "]");
}

}  // namespace

GainTable gain_table() noexcept { return {kRows, static_cast<int>(std::size(kRows))}; }

void Gains::validate() const {
  if (valid()) return;
  for (const GainInfo& info : kRows) check_gain(info, this->*info.member);
  throw Error("gain 'contact_force_off' must be below 'contact_force_on': got " +
              to_text(contact_force_off) + " and " + to_text(contact_force_on));
}

bool Gains::valid() const noexcept {
  for (const GainInfo& info : kRows) {
    if (!in_range(info, this->*info.member)) return false;
  }
  return contact_force_off < contact_force_on;
}

bool Gains::operator==(const Gains& other) const {
  for (const GainInfo& info : kRows) {
    if (this->*info.member != other.*info.member) return false;
  }
  return true;
}

double get_gain(const Gains& gains, std::string_view name) { return gains.*find_gain(name).member; }

void set_gain(Gains& gains, std::string_view name, double value) {
  const GainInfo& info = find_gain(name);
  check_gain(info, value);
  gains.*info.member = value;
}

}  // namespace surefoot
