// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "estimator/contact/leg_forces.hpp"

namespace surefoot {

/// Motion and forces of the feet of which FrictionEstimate::update() learns.
struct FrictionInput {
  const FeetMatrix& v_contact;     ///< velocities of the contact points, world axes [m/s]
  const FeetMatrix& forces;        ///< forces of the ground on the feet, world axes [N]
  const Eigen::Vector4d& contact;  ///< contact confidence per foot, 0 .. 1
  const Vector3& normal;           ///< of the ground, world axes
  double v_error;                  ///< possible error of the velocity of the base [m/s]
  double travelled;                ///< distance that the base moved since the last call [m]
  bool stepping;                   ///< feet step, or stepped lately
};

/// Friction coefficient of the ground, learnt from feet that slide and from feet that hold.
///
/// Coulomb's law holds for a sliding foot: its tangential force is directed against its velocity
/// and is mu times its normal force f_n. The estimate is the least-squares solution over the
/// sliding, with the weight f_n d of a sliding distance d, and RobotConfig::friction as a
/// measurement of small weight:
///   mu = (sum |f_t| d + k mu_0) / (sum f_n d + k).
/// A foot that holds shows that mu is at least |f_t| / f_n. Sliding at a smaller ratio contradicts
/// this: the sliding is then a wrong velocity, or the ground has changed. It counts only after it
/// has lasted long enough to lower the ratio that held. Both memories fade with the distance that
/// the robot travels, because another place may have another friction.
///
/// The speed of the slowest foot is subtracted, up to the possible error of the base velocity: a
/// speed that all feet have in common may be such an error. Motion of a soft sole while its load
/// changes does not count: after touchdown, sliding counts only with enough load and speed, and
/// only if the force opposes it.
///
/// Source of the ratio of a slipping foot as friction: Focchi et al. 2018, "Slip detection and
/// recovery for quadruped robots". Real-time: yes.
class FrictionEstimate {
 public:
  explicit FrictionEstimate(const Robot& robot);

  /// Process one tick.
  void update(const FrictionInput& input, double dt) noexcept;

  /// Learnt friction coefficient, 0.1 .. RobotConfig::friction; initially RobotConfig::friction.
  double coefficient() const noexcept { return coefficient_; }
  /// Coefficient that the feet may use, as a share of RobotConfig::friction: the learnt one, less
  /// the error that an estimate from sliding feet has.
  double usable_share() const noexcept;
  /// How near the force of each foot is to the learnt limit of friction, 0 .. 1. It is 0 before a
  /// foot has slid, because then the limit is not known, and while feet step.
  const Eigen::Vector4d& at_limit() const noexcept { return at_limit_; }
  /// Whether each foot may slide: its force is directed against its velocity, as Coulomb's law
  /// demands. Feet that only seem to move, because the velocity of the base is wrong, have no such
  /// force. False while feet step.
  const std::array<bool, kLegs>& slides() const noexcept { return slides_; }

  void reset() noexcept;

 private:
  void filter_velocities(const FrictionInput& input, double dt) noexcept;
  double common_error(double v_error) const noexcept;
  void learn_from_foot(int leg, const FrictionInput& input, double common_speed,
                       double dt) noexcept;
  double limit_share(double ratio) const noexcept;
  double confidence() const noexcept;
  void slide(double ratio, double weighted_distance) noexcept;

  double assumed_;  // RobotConfig::friction
  double weight_;   // [N] of the robot
  double height_;   // [m] of the centre of mass above the feet, standing pose
  double coefficient_;
  double friction_work_ = 0.0;                  // [m g h] work of the sliding feet against friction
  double sliding_ = 0.0;                        // [m g h] the same for a friction coefficient of 1
  double held_ = 0.0;                           // |f_t| / f_n that has held
  FeetMatrix v_filtered_ = FeetMatrix::Zero();  // [m/s] along the ground
  Eigen::Vector4d stance_time_ = Eigen::Vector4d::Zero();  // [s] since touchdown
  std::array<bool, kLegs> slides_{};
  Eigen::Vector4d at_limit_ = Eigen::Vector4d::Zero();
  Eigen::Vector4d holding_ratio_ = Eigen::Vector4d::Zero();  // |f_t| / f_n, low-passed
};

}  // namespace surefoot
