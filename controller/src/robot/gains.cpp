// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/gains.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "common/text.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

namespace {

using G = Gains;
constexpr std::string_view kBody = "Body";
constexpr std::string_view kFeet = "Feet";
constexpr std::string_view kJoints = "Joints";
constexpr std::string_view kProgram = "Quadratic program";
constexpr std::string_view kReference = "Body reference";
constexpr std::string_view kEstimator = "Estimator";
constexpr std::string_view kCommand = "Command";
constexpr GainInfo kRows[] = {
    {kBody, "com_kp_horizontal", "1/s^2", 0, 2000, &G::com_kp_horizontal,
     "sway stiffness per unit mass"},
    {kBody, "com_kd_horizontal", "1/s", 0, 200, &G::com_kd_horizontal,
     "sway damping per unit mass"},
    {kBody, "com_kp_vertical", "1/s^2", 0, 2000, &G::com_kp_vertical,
     "height stiffness per unit mass"},
    {kBody, "com_kd_vertical", "1/s", 0, 200, &G::com_kd_vertical, "height damping per unit mass"},
    {kBody, "base_kp_tilt", "1/s^2", 0, 2000, &G::base_kp_tilt, "roll and pitch stiffness"},
    {kBody, "base_kd_tilt", "1/s", 0, 200, &G::base_kd_tilt, "roll and pitch damping"},
    {kBody, "base_kp_yaw", "1/s^2", 0, 2000, &G::base_kp_yaw, "yaw stiffness"},
    {kBody, "base_kd_yaw", "1/s", 0, 200, &G::base_kd_yaw, "yaw damping"},
    {kFeet, "foot_kp", "1/s^2", 0, 5000, &G::foot_kp,
     "stiffness that returns a foot to its anchor"},
    {kFeet, "foot_kd", "1/s", 0, 500, &G::foot_kd, "damping of a foot that moves"},
    {kFeet, "foot_speed", "m/s", 0.01, 100, &G::foot_speed,
     "the return's greatest speed, however far a foot is off: a leg that is thrown throws the "
     "body; 100: as fast as foot_kp has it"},
    {kFeet, "foot_step", "m", 0, 0.5, &G::foot_step,
     "farthest that a foot which steps is put down from its place, towards the capture point near "
     "or beyond the support's edge; 0: none steps, one that is thrown up comes back"},
    {kJoints, "posture_kp", "1/s^2", 0, 5000, &G::posture_kp, "stiffness of the posture task"},
    {kJoints, "posture_kd", "1/s", 0, 500, &G::posture_kd, "damping of the posture task"},
    {kJoints, "joint_limit_rate", "1/s", 1, 200, &G::joint_limit_rate,
     "how fast a joint may approach its position limit, per distance left"},
    {kJoints, "joint_limit_margin", "rad", 0, 0.5, &G::joint_limit_margin,
     "kept from the position limits"},
    {kProgram, "weight_com_horizontal", "1", 1e-4, 1e4, &G::weight_com_horizontal,
     "importance of horizontal acceleration of the centre of mass"},
    {kProgram, "weight_com_vertical", "1", 1e-4, 1e4, &G::weight_com_vertical,
     "importance of vertical acceleration of the centre of mass"},
    {kProgram, "weight_base_tilt", "1", 1e-4, 1e4, &G::weight_base_tilt,
     "importance of roll and pitch acceleration"},
    {kProgram, "weight_base_yaw", "1", 1e-4, 1e4, &G::weight_base_yaw,
     "importance of yaw acceleration"},
    {kProgram, "weight_momentum", "1", 0, 1e4, &G::weight_momentum,
     "importance of angular momentum about the centre of mass"},
    {kProgram, "momentum_kd", "1/s", 0, 200, &G::momentum_kd, "damping of angular momentum"},
    {kProgram, "weight_posture", "1", 0, 1e2, &G::weight_posture,
     "pull of all joints towards the posture"},
    {kProgram, "weight_posture_free", "1", 1e-4, 1e2, &G::weight_posture_free,
     "the same for joints that no foot decides: further joints, legs near singular"},
    {kProgram, "weight_foot_soft", "1", 1e-2, 1e3, &G::weight_foot_soft,
     "importance of the acceleration of a foot whose leg is near singular"},
    {kProgram, "weight_force", "1", 1e-6, 1e2, &G::weight_force,
     "pull towards the even force distribution"},
    {kProgram, "weight_smooth", "1", 0, 1e2, &G::weight_smooth,
     "pull towards the forces of the tick before"},
    {kProgram, "penalty_torque", "1", 1, 1e4, &G::penalty_torque,
     "price of torque beyond the motor's limit"},
    {kProgram, "penalty_joint_limit", "1", 0.1, 1e4, &G::penalty_joint_limit,
     "price of breaking a joint's position or velocity limit"},
    {kProgram, "penalty_hold_down", "1", 1e-3, 1e3, &G::penalty_hold_down,
     "price of a stance foot pressed less than hold_down"},
    {kProgram, "hold_down", "m g", 0, 0.2, &G::hold_down,
     "least normal force of a foot in contact"},
    {kProgram, "edge_margin", "m", 1e-3, 1, &G::edge_margin,
     "capture point nearer than this to the support's edge: surviving comes first"},
    {kProgram, "edge_tilt", "1", 0.01, 1, &G::edge_tilt,
     "share of weight_base_tilt left at the edge, where turning the body helps to stay up"},
    {kProgram, "edge_height", "1", 0.01, 1, &G::edge_height,
     "share of weight_com_vertical that is left at the support's edge"},
    {kProgram, "edge_load", "m g", 0, 0.9, &G::edge_load,
     "least load planned for all feet at the edge (0.35 less away from it): a body on its way down "
     "again brakes no push"},
    {kProgram, "edge_rise", "m/s", 0.1, 100, &G::edge_rise,
     "upward speed at which a tilted body is no longer asked back nor its turning damped, and from "
     "3/8 of which on less: that would throw it further up; 100: however fast it rises"},
    {kProgram, "force_max_contact", "m g", 0.3, 10, &G::force_max_contact,
     "greatest normal force of a foot in contact"},
    {kProgram, "force_lost_contact", "m g", 0.05, 1, &G::force_lost_contact,
     "greatest normal force of a stance foot whose contact is lost"},
    {kProgram, "share_lost_contact", "1", 0.01, 1, &G::share_lost_contact,
     "share of the even load offered to a stance foot whose contact is lost"},
    {kReference, "reference_speed", "m/s", 1e-3, 2, &G::reference_speed,
     "greatest speed of the body reference"},
    {kReference, "reference_turn_speed", "rad/s", 1e-3, 10, &G::reference_turn_speed,
     "greatest turning speed of the body reference"},
    {kReference, "reference_acceleration", "m/s^2", 1e-2, 50, &G::reference_acceleration,
     "the same of its change: a stop at the support's edge throws the body by as much"},
    {kReference, "reference_turn_acceleration", "rad/s^2", 1e-1, 200,
     &G::reference_turn_acceleration, "the same of turning"},
    {kReference, "reference_time", "s", 0.01, 5, &G::reference_time,
     "how slowly the body reference comes to rest at its target"},
    {kReference, "reach_joint_margin", "rad", 0, 0.5, &G::reach_joint_margin,
     "joint angle left when the body reference is at its farthest"},
    {kReference, "reach_support_margin", "m", 0, 0.5, &G::reach_support_margin,
     "distance of the centre of mass from the support's edge, the same"},
    {kReference, "reach_foot_depth", "m", 0, 0.5, &G::reach_foot_depth,
     "distance of every foot below its hip axis, the same: level with it a leg is singular"},
    {kEstimator, "noise_gyroscope", "rad/s", 1e-6, 10, &G::noise_gyroscope,
     "gyroscope noise, standard deviation of a sample, before it has been measured"},
    {kEstimator, "noise_accelerometer", "m/s^2", 1e-4, 100, &G::noise_accelerometer,
     "accelerometer noise, standard deviation of a sample, before it has been measured"},
    {kEstimator, "gyroscope_drift", "rad/s/sqrt(s)", 0, 1, &G::gyroscope_drift,
     "how fast the gyroscope's bias wanders"},
    {kEstimator, "accelerometer_drift", "m/s^2/sqrt(s)", 0, 10, &G::accelerometer_drift,
     "how fast the accelerometer's bias wanders"},
    {kEstimator, "accelerometer_drift_vertical", "m/s^2/sqrt(s)", 0, 10,
     &G::accelerometer_drift_vertical, "how fast it wanders along the vertical besides"},
    {kEstimator, "start_tilt", "rad", 1e-4, 3, &G::start_tilt, "doubt about the tilt at the start"},
    {kEstimator, "start_velocity", "m/s", 1e-4, 10, &G::start_velocity, "doubt about the velocity"},
    {kEstimator, "start_gyroscope_bias", "rad/s", 1e-6, 1, &G::start_gyroscope_bias,
     "doubt about the gyroscope's bias"},
    {kEstimator, "start_accelerometer_bias", "m/s^2", 1e-6, 5, &G::start_accelerometer_bias,
     "doubt about the accelerometer's bias"},
    {kEstimator, "noise_foot_position", "m", 1e-6, 1, &G::noise_foot_position,
     "noise of a foot position from the joint angles, before it has been measured"},
    {kEstimator, "noise_foot_slip", "m/s", 1e-6, 10, &G::noise_foot_slip,
     "how fast a stance foot may be believed to wander"},
    {kEstimator, "noise_foot_motion", "1", 0, 10, &G::noise_foot_motion,
     "share of a foot's speed relative to the base by which it may be believed to wander"},
    {kEstimator, "leg_scale", "1", 0, 1, &G::leg_scale,
     "share of the way walked that lengths of legs, soles and slips leave in doubt"},
    {kEstimator, "gate_foot", "sigma", 1, 100, &G::gate_foot,
     "innovations beyond this are not believed"},
    {kEstimator, "contact_force_on", "m g", 0.001, 0.5, &G::contact_force_on,
     "load that makes a contact"},
    {kEstimator, "contact_force_off", "m g", 0.001, 0.5, &G::contact_force_off,
     "load that ends a contact"},
    {kEstimator, "contact_force_width", "m g", 0.001, 0.5, &G::contact_force_width,
     "how far from either a load must be to speak clearly"},
    {kEstimator, "contact_dwell", "s", 0, 0.5, &G::contact_dwell,
     "how long a change must last to count"},
    {kEstimator, "slip_speed", "m/s", 0.01, 10, &G::slip_speed,
     "a loaded foot faster than this slips"},
    {kEstimator, "slip_friction", "1", 0.1, 1, &G::slip_friction,
     "what is left of the friction coefficient of a foot that slips"},
    {kEstimator, "payload_time", "s", 0.05, 100, &G::payload_time,
     "how slowly a wrench is believed that the joint torques do not explain"},
    {kEstimator, "payload_max", "m g", 0, 5, &G::payload_max, "greatest such force believed"},
    {kEstimator, "push_time", "s", 0.001, 10, &G::push_time,
     "how slowly a force is believed that the commands do not explain; up to 8/3 as fast where it "
     "surprises along the ground"},
    {kEstimator, "push_dead_band", "m/s^2", 0, 100, &G::push_dead_band,
     "unexplained acceleration that is taken for noise"},
    {kEstimator, "push_max", "m/s^2", 0, 100, &G::push_max,
     "greatest outside acceleration believed"},
    {kEstimator, "push_resist", "1", 0, 1, &G::push_resist,
     "share of an outside force that the feet lean against at once"},
    {kCommand, "fall_tilt", "rad", 0.1, 1.6, &G::fall_tilt,
     "tilt of the base at which the motors damp"},
    {kCommand, "damping_kd", "N.m.s/rad", 0.0625, 50, &G::damping_kd,
     "motor-side damping when something is wrong"},
    {kCommand, "fold_wait", "s", 0, 3, &G::fold_wait,
     "how long a pair of legs of a lying body that leans waits while the other folds"},
};

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
