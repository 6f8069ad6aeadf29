// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <pinocchio/multibody/fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "surefoot/robot_config.hpp"

namespace surefoot {

/// Model and configuration of a robot, immutable. A Robot is cheap to copy and safe to share
/// between threads.
///
/// q and v follow Pinocchio: q = [p_world_base, quaternion x y z w, joints], v = [linear and
/// angular velocity of the base in base axes, joint velocities]. Joints in q and v are in
/// Pinocchio's order, which differs from SDK motor order: convert with motor_to_q() and
/// motor_to_v(). Joints are matched to motors by name.
class Robot {
 public:
  /// Build from a Pinocchio model with a free-flyer root. RobotConfig::armature replaces the
  /// armature of the model. Throws surefoot::Error if the configuration is invalid or does not fit
  /// the model, or if the model is not a quadruped that can stand: a moving body without inertia, a
  /// turned joint axis, a foot in the wrong quadrant, or a limit that no motor has.
  Robot(const pinocchio::Model& model, const RobotConfig& config);

  /// Build from the text that pinocchio::Model::saveToString() of the same Pinocchio version wrote.
  /// Throws surefoot::Error if the text cannot be read, or if the configuration is invalid or does
  /// not fit the model.
  static Robot from_serialized_model(const std::string& text, const RobotConfig& config);

  /// Read a .robot file that save() wrote. No URDF parser and no meshes are needed. Throws
  /// surefoot::Error if the file cannot be read, is damaged, or has another version.
  static Robot load(const std::string& path);
  /// Write a .robot file: configuration, model and checksum. Throws surefoot::Error if the file
  /// cannot be written.
  void save(const std::string& path) const;

  const pinocchio::Model& model() const noexcept;  ///< model, with RobotConfig::armature
  const RobotConfig& config() const noexcept;      ///< configuration
  /// Return the model as text for pinocchio::Model::loadFromString() of the same version.
  std::string serialized_model() const;

  int nq() const noexcept;       ///< size of q; 19 with twelve joints
  int nv() const noexcept;       ///< size of v; 18 with twelve joints
  double mass() const noexcept;  ///< [kg] total mass

  /// Return what is possible but unusual in model and configuration, one sentence each.
  const std::vector<std::string>& doubts() const noexcept;

  /// Return the index in v of each SDK motor. Real-time: yes.
  const std::array<int, kMotors>& motor_to_v() const noexcept;
  /// Return the index in q of each SDK motor. Real-time: yes.
  const std::array<int, kMotors>& motor_to_q() const noexcept;
  /// Return the Pinocchio frame id of each foot, FR FL RR RL. Real-time: yes.
  const std::array<int, kLegs>& foot_frame_ids() const noexcept;

  /// Return q of the standing pose, shape (nq,), with the base level at the world origin.
  /// Real-time: no.
  Eigen::VectorXd q_standing() const;

  struct Data;  ///< internal data, defined in the library

 private:
  std::shared_ptr<const Data> data_;
};

}  // namespace surefoot
