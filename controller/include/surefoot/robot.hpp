// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <pinocchio/multibody/fwd.hpp>
#include <string>
#include <string_view>

#include "surefoot/robot_config.hpp"

namespace surefoot {

/// A robot: the part that never changes. Cheap to copy, safe to share between threads.
///
/// q = [p_world_base, quaternion x y z w, joints], v = [v, w of the base in its own axes, joint
/// velocities], as Pinocchio has them. Joints in q and v follow Pinocchio's order, which is not the
/// SDK's: go between the two with motor_to_v() and motor_to_q() only. They are matched by name.
class Robot {
 public:
  /// Build from a Pinocchio model with a free-flyer root. Reflected rotor inertia of the
  /// configuration becomes the model's armature. Throws surefoot::Error.
  Robot(const pinocchio::Model& model, const RobotConfig& config);

  /// Build from the text that pinocchio::Model::saveToString() makes (same Pinocchio version).
  static Robot from_serialized_model(const std::string& text, const RobotConfig& config);

  /// Read a .robot file that save() wrote; throws surefoot::Error. No parser, no mesh needed.
  static Robot load(const std::string& path);
  void save(const std::string& path) const;

  const pinocchio::Model& model() const noexcept;
  const RobotConfig& config() const noexcept;
  std::string serialized_model() const;

  int nq() const noexcept;
  int nv() const noexcept;
  double mass() const noexcept;  ///< [kg]

  /// Index in v (or q) of SDK motor `i`.
  const std::array<int, kMotors>& motor_to_v() const noexcept;
  const std::array<int, kMotors>& motor_to_q() const noexcept;
  /// Pinocchio frame id of each foot, FR FL RR RL.
  const std::array<int, kLegs>& foot_frame_ids() const noexcept;

  /// q with the base at the origin, level, and the legs in the standing pose. Shape (nq,).
  Eigen::VectorXd q_standing() const;

  struct Data;  // defined in the library

 private:
  std::shared_ptr<const Data> data_;
};

}  // namespace surefoot
