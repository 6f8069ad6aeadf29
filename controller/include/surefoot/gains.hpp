// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace surefoot {

/// Parameters of standing and walking that are tuned per robot. Constants in the source are the
/// same for all robots; each says where its value comes from.
///
/// gain_table() has unit, range and full meaning of every gain. The values here are the library's
/// defaults; RobotConfig::gains has the values of one robot. Stiffness and damping are per unit of
/// inertia, so their values are similar on all robots. The unit m g is the weight of the robot.
struct Gains {
  // Body: feedback on the centre of mass and on the base orientation.
  double com_kp_horizontal = 60.0;  ///< [1/s^2] horizontal stiffness of the centre of mass
  double com_kd_horizontal = 15.0;  ///< [1/s] horizontal damping of the centre of mass
  double com_kp_vertical = 150.0;   ///< [1/s^2] vertical stiffness of the centre of mass
  double com_kd_vertical = 24.0;    ///< [1/s] vertical damping of the centre of mass
  double base_kp_tilt = 700.0;      ///< [1/s^2] roll and pitch stiffness
  double base_kd_tilt = 46.0;       ///< [1/s] roll and pitch damping
  double base_kp_yaw = 200.0;       ///< [1/s^2] yaw stiffness
  double base_kd_yaw = 26.0;        ///< [1/s] yaw damping
  // Feet: feedback on the positions of the feet.
  double foot_kp = 2500.0;  ///< [1/s^2] stiffness of a foot about its reference position
  double foot_kd = 50.0;    ///< [1/s] damping of the velocity of a foot
  // Joints: posture task, and approach to the joint limits.
  double posture_kp = 100.0;  ///< [1/s^2] stiffness of the posture task
  double posture_kd = 20.0;   ///< [1/s] damping of the posture task
  /// [1/s] Greatest speed of a joint towards its limit, divided by the distance left.
  double joint_limit_rate = 30.0;
  double joint_limit_margin = 0.02;  ///< [rad] distance kept from the position limits
  // QP: weights of tasks, penalties of elastic constraints, bounds on the contact forces.
  double weight_com_horizontal = 0.6;  ///< [1] weight of the horizontal centre-of-mass acceleration
  double weight_com_vertical = 0.2;    ///< [1] weight of the vertical centre-of-mass acceleration
  double weight_base_tilt = 6.0;       ///< [1] weight of the roll and pitch acceleration
  double weight_base_yaw = 0.6;        ///< [1] weight of the yaw acceleration
  double weight_momentum = 0.0;  ///< [1] weight of the angular momentum about the centre of mass
  double momentum_kd = 5.0;      ///< [1/s] damping of the angular momentum
  double weight_posture = 0.0;   ///< [1] weight of the posture task for all joints
  /// [1] Weight of the posture task for joints outside the legs, and for legs near a singularity.
  double weight_posture_free = 0.001;
  /// [1] Weight of the acceleration of a foot whose leg is near a singularity.
  double weight_foot_soft = 1.0;
  double weight_force = 0.1;     ///< [1] weight of the difference from the even forces
  double weight_smooth = 0.0;    ///< [1] weight of the difference from the forces of the last tick
  double penalty_torque = 30.0;  ///< [1] penalty for torque above the motor limit
  /// [1] Penalty for violating a joint's position or velocity limit.
  double penalty_joint_limit = 10.0;
  /// [1] Penalty for a normal force of a stance foot below hold_down.
  double penalty_hold_down = 0.4;
  double hold_down = 0.04;  ///< [m g] hold-down: smallest normal force of a stance foot in contact
  /// [m] Distance of the capture point from the support edge below which balance has priority.
  double edge_margin = 0.06;
  double edge_tilt = 0.05;   ///< [1] factor on weight_base_tilt at the support edge
  double edge_height = 1.0;  ///< [1] factor on weight_com_vertical at the support edge
  double edge_load =
      0.3;  ///< [m g] smallest desired force on all feet together at the support edge
  /// [m/s] Upward speed of the body at which the desired tilt acceleration is zero.
  double edge_rise = 100.0;
  double force_max_contact = 3.0;  ///< [m g] greatest normal force of a foot in contact
  /// [m g] Greatest normal force of a stance foot that has lost contact.
  double force_lost_contact = 0.3;
  /// [1] Share of the even load planned for a stance foot that has lost contact.
  double share_lost_contact = 0.3;
  // Body reference: speed and range.
  double reference_speed = 0.15;        ///< [m/s] greatest speed of the body reference
  double reference_turn_speed = 0.8;    ///< [rad/s] greatest angular speed of the reference
  double reference_acceleration = 0.4;  ///< [m/s^2] greatest acceleration of the reference
  /// [rad/s^2] Greatest angular acceleration of the body reference.
  double reference_turn_acceleration = 4.0;
  double reference_time = 0.1;  ///< [s] time constant of the approach to the target
  /// [rad] Distance from the joint limits at which the body reference stops.
  double reach_joint_margin = 0.087;
  /// [m] Distance of the centre of mass from the support edge at which the body reference stops.
  double reach_support_margin = 0.06;
  /// [m] Distance of a foot below its hip axis at which the body reference stops.
  double reach_foot_depth = 0.07;
  // Walking: gait and swing feet. Unit h: height of the centre of mass above the feet in the
  // standing pose; g: gravity.
  double gait_period = 2.4;  ///< [sqrt(h/g)] longest period of the gait
  double gait_duty = 0.5;    ///< [1] greatest share of the period in which a foot stands
  /// [h] Longest distance that the body moves while a foot stands; at higher speed the period is
  /// shorter.
  double gait_stance_travel = 0.9;
  /// [h corner_speed] Greatest speed of a swing foot past the body; at higher speed the duty is
  /// smaller. With 1.0 a go2 falls at 1.5 m/s in one of four runs.
  double gait_swing_speed = 0.8;
  /// [sqrt(h/g)] Distance of a foothold ahead, per velocity beyond the commanded one; 1: the
  /// capture point.
  double foothold_feedback = 0.85;
  /// [h] Capture margin below which a standing robot that has lost two contacts steps; -10: never.
  double recovery_margin = 0.05;
  double swing_height = 0.15;         ///< [h] height to which a swing foot rises
  double swing_landing_speed = 0.16;  ///< [sqrt(g h)] downward speed at which a foot lands
  /// [1] Weight of the roll, pitch and yaw acceleration of a robot that steps.
  double walk_weight_base_rotation = 40.0;
  /// [1/s] joint_limit_rate of a walking robot.
  double walk_joint_limit_rate = 100.0;
  /// [m g] hold_down while one foot of a walking robot swings.
  double walk_hold_down = 0.07;
  double walk_acceleration = 0.2;        ///< [g] greatest acceleration of the commanded velocity
  double walk_turn_acceleration = 0.25;  ///< [g/h] the same of the commanded yaw rate
  /// [m g sqrt(g h)] Power peaks of a trot in place.
  double walk_power_rest = 0.45;
  /// [m g sqrt(g h)] Additional power peaks at a speed of sqrt(g h); they grow with the cube of the
  /// speed.
  double walk_power_rise = 3.8;
  double walk_speed_forward = 1.2;    ///< [sqrt(g h)] greatest commanded speed forward
  double walk_speed_backward = 0.6;   ///< [sqrt(g h)] greatest commanded speed backward
  double walk_speed_sideways = 0.47;  ///< [sqrt(g h)] greatest commanded speed sideways
  double walk_turn_speed = 0.52;      ///< [sqrt(g/h)] greatest commanded yaw rate
  // Gait walk: one foot swings at a time.
  double walk_gait_period = 6.0;  ///< [sqrt(h/g)] gait_period of the gait walk
  double walk_gait_duty = 0.8;    ///< [1] share of the period in which a foot stands, gait walk
  /// [h] Distance of the zero-moment point from the edges of the support triangle, gait walk. With
  /// 0.12 the sway of a b1 reaches 0.066 m/s RMS; with 0.09 it has fewer than three feet loaded in
  /// 6 % of a walk to the side.
  double walk_gait_margin = 0.1;
  double walk_gait_swing_height = 0.2;  ///< [h] swing_height of the gait walk
  double walk_gait_speed = 0.15;        ///< [sqrt(g h)] greatest commanded speed, gait walk
  double walk_gait_turn_speed = 0.1;    ///< [sqrt(g/h)] greatest commanded yaw rate, gait walk
  // Estimator: noise, contact detection, external wrench.
  double noise_gyroscope = 0.01;      ///< [rad/s] gyroscope noise until it has been measured
  double noise_accelerometer = 0.1;   ///< [m/s^2] accelerometer noise until it has been measured
  double gyroscope_drift = 1e-4;      ///< [rad/s/sqrt(s)] random walk of the gyroscope bias
  double accelerometer_drift = 1e-3;  ///< [m/s^2/sqrt(s)] random walk of the accelerometer bias
  /// [m/s^2/sqrt(s)] Additional random walk of the accelerometer bias along the vertical.
  double accelerometer_drift_vertical = 0.01;
  double start_tilt = 0.3;      ///< [rad] greatest initial standard deviation of the tilt
  double start_velocity = 0.5;  ///< [m/s] initial standard deviation of the velocity
  /// [rad/s] Initial standard deviation of the gyroscope bias.
  double start_gyroscope_bias = 0.02;
  /// [m/s^2] Initial and long-term standard deviation of the accelerometer bias.
  double start_accelerometer_bias = 0.1;
  double noise_foot_position = 0.002;  ///< [m] noise of a foot position until it has been measured
  double noise_foot_slip = 0.0005;     ///< [m/s] assumed velocity noise of a stance foot
  /// [1] Additional velocity noise of a foot, as a share of its speed relative to the base.
  double noise_foot_motion = 0.015;
  double leg_scale = 0.01;          ///< [1] position error per distance travelled
  double gate_foot = 4.0;           ///< [sigma] innovation gate of a foot
  double contact_force_on = 0.07;   ///< [m g] load above which a contact begins
  double contact_force_off = 0.06;  ///< [m g] load below which a contact ends
  /// [m g] Distance of a load from these two thresholds at which the load is clear evidence.
  double contact_force_width = 0.02;
  /// [s] Time in which clear evidence changes the contact confidence from 0 to 1.
  double contact_dwell = 0.01;
  /// [m/s] Speed above that of the slowest loaded foot at which a loaded foot slips.
  double slip_speed = 0.15;
  double slip_friction = 0.5;   ///< [1] factor on the friction coefficient of a slipping foot
  double payload_time = 0.15;   ///< [s] time constant of the sustained external wrench
  double payload_max = 1.2;     ///< [m g] greatest sustained external force
  double push_time = 0.016;     ///< [s] time constant of the push
  double push_dead_band = 0.5;  ///< [m/s^2] dead band of the push
  double push_max = 20.0;       ///< [m/s^2] greatest acceleration of a push
  double push_resist = 1.0;  ///< [1] share of the external force that the feet counteract at once
  // Command: damping, and folding of the legs.
  double fall_tilt = 1.0;   ///< [rad] tilt of the base above which the motors damp
  double damping_kd = 3.0;  ///< [N.m.s/rad] Kd of the motors in damping
  /// [s] Longest time for which one diagonal pair of legs waits for the other to fold; 0: no wait.
  double fold_wait = 0.0;

  /// Throw surefoot::Error if a gain is not finite or outside its range, or if contact_force_off is
  /// not below contact_force_on. The message names the first invalid gain.
  void validate() const;
  /// Return whether validate() would not throw. Real-time: yes.
  bool valid() const noexcept;

  /// Return whether all gains are equal. Real-time: yes.
  bool operator==(const Gains& other) const;
};

/// One row of gain_table().
struct GainInfo {
  std::string_view group;    ///< part of the controller: Body, Feet, Joints, ...
  std::string_view name;     ///< name of the member of Gains
  std::string_view unit;     ///< unit of the value, such as "1/s^2"; "1": dimensionless
  double minimum;            ///< smallest valid value
  double maximum;            ///< largest valid value
  double Gains::* member;    ///< pointer to the member
  std::string_view meaning;  ///< meaning of the gain, in a phrase
};

/// Range over the rows of all gains, in the order of the struct.
struct GainTable {
  const GainInfo* rows;                                ///< first row; the memory is static
  int size;                                            ///< number of rows
  const GainInfo* begin() const { return rows; }       ///< first row
  const GainInfo* end() const { return rows + size; }  ///< end of the last row
};
/// Return the table of all gains. Real-time: yes.
GainTable gain_table() noexcept;

/// Return a gain by name. Throws surefoot::Error if the name is unknown; the message lists the
/// nearest names. Real-time: no.
double get_gain(const Gains& gains, std::string_view name);
/// Set a gain by name. Throws surefoot::Error if the name is unknown, or the value is not finite or
/// out of range. Real-time: no.
void set_gain(Gains& gains, std::string_view name, double value);

}  // namespace surefoot
