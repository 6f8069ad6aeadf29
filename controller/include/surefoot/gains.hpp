// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace surefoot {

/// Parameters of standing that are tuned per robot. Constants in the source are the same for all
/// robots; each says where its value comes from.
///
/// gain_table() has unit, range and meaning of every gain; the values here are the library's
/// defaults, and RobotConfig::gains has the values of a robot. Stiffness and damping are per unit
/// of inertia, so their values are similar on all robots.
struct Gains {
  // Body: feedback on the centre of mass and on the base orientation.
  double com_kp_horizontal = 60.0;
  double com_kd_horizontal = 15.0;
  double com_kp_vertical = 150.0;
  double com_kd_vertical = 24.0;
  double base_kp_tilt = 700.0;
  double base_kd_tilt = 46.0;
  double base_kp_yaw = 200.0;
  double base_kd_yaw = 26.0;
  // Feet: feedback on the positions of the feet, and recovery steps.
  double foot_kp = 2500.0;
  double foot_kd = 50.0;
  double foot_speed = 100.0;
  double foot_step = 0.0;
  // Joints: posture task, and approach to the joint limits.
  double posture_kp = 100.0;
  double posture_kd = 20.0;
  double joint_limit_rate = 30.0;
  double joint_limit_margin = 0.02;
  // QP: weights of tasks, penalties of elastic constraints, bounds on the contact forces.
  double weight_com_horizontal = 0.6;
  double weight_com_vertical = 0.2;
  double weight_base_tilt = 6.0;
  double weight_base_yaw = 0.6;
  double weight_momentum = 0.0;
  double momentum_kd = 5.0;
  double weight_posture = 0.0;
  double weight_posture_free = 0.001;
  double weight_foot_soft = 1.0;
  double weight_force = 0.1;
  double weight_smooth = 0.0;
  double penalty_torque = 30.0;
  double penalty_joint_limit = 10.0;
  double penalty_hold_down = 0.4;
  double hold_down = 0.04;
  double edge_margin = 0.06;
  double edge_tilt = 0.05;
  double edge_height = 1.0;
  double edge_load = 0.3;
  double edge_rise = 100.0;
  double force_max_contact = 3.0;
  double force_lost_contact = 0.3;
  double share_lost_contact = 0.3;
  // Body reference: speed and range.
  double reference_speed = 0.15;
  double reference_turn_speed = 0.8;
  double reference_acceleration = 0.4;
  double reference_turn_acceleration = 4.0;
  double reference_time = 0.1;
  double reach_joint_margin = 0.087;
  double reach_support_margin = 0.06;
  double reach_foot_depth = 0.07;
  // Estimator: noise, contact detection, external wrench.
  double noise_gyroscope = 0.01;
  double noise_accelerometer = 0.1;
  double gyroscope_drift = 1e-4;
  double accelerometer_drift = 1e-3;
  double accelerometer_drift_vertical = 0.01;
  double start_tilt = 0.3;
  double start_velocity = 0.5;
  double start_gyroscope_bias = 0.02;
  double start_accelerometer_bias = 0.1;
  double noise_foot_position = 0.002;
  double noise_foot_slip = 0.0005;
  double noise_foot_motion = 0.015;
  double leg_scale = 0.01;
  double gate_foot = 4.0;
  double contact_force_on = 0.07;
  double contact_force_off = 0.06;
  double contact_force_width = 0.02;
  double contact_dwell = 0.01;
  double slip_speed = 0.15;
  double slip_friction = 0.5;
  double payload_time = 0.15;
  double payload_max = 1.2;
  double push_time = 0.016;
  double push_dead_band = 0.5;
  double push_max = 20.0;
  double push_resist = 1.0;
  // Command: damping, and folding of the legs.
  double fall_tilt = 1.0;
  double damping_kd = 3.0;
  double fold_wait = 0.0;

  /// Throw surefoot::Error if a gain is not finite or outside its range, or if contact_force_off
  /// is not below contact_force_on. The message names the first such gain.
  void validate() const;
  bool valid() const noexcept;  ///< true if validate() would not throw; real-time: yes

  bool operator==(const Gains& other) const;
};

/// One row of gain_table().
struct GainInfo {
  std::string_view group;  ///< part of the controller: Body, Feet, Joints, ...
  std::string_view name;
  std::string_view unit;
  double minimum;  ///< smallest valid value
  double maximum;  ///< largest valid value
  double Gains::* member;
  std::string_view meaning;
};

/// Range over the rows of all gains, in the order of the struct.
struct GainTable {
  const GainInfo* rows;
  int size;
  const GainInfo* begin() const { return rows; }
  const GainInfo* end() const { return rows + size; }
};
/// Return the table of all gains. Real-time: yes.
GainTable gain_table() noexcept;

/// Return a gain by name; throws surefoot::Error with the nearest valid names. Real-time: no.
double get_gain(const Gains& gains, std::string_view name);
/// Set a gain by name; throws surefoot::Error on an unknown name or a value that is not finite or
/// out of range. Real-time: no.
void set_gain(Gains& gains, std::string_view name, double value);

}  // namespace surefoot
