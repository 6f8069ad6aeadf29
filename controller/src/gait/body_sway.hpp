// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "gait/gait_size.hpp"
#include "gait/velocity_change.hpp"

namespace surefoot {

/// The next swing of a foot, as planned. Times are from now on [s], positions in the world [m].
struct NextSwing {
  double begin;          ///< lift-off; 0 while the foot swings; infinite in a trot
  double end;            ///< touchdown
  double landed;         ///< time since the last touchdown; 0 while the foot swings
  Eigen::Vector2d from;  ///< present contact point
  Eigen::Vector2d to;    ///< foothold
};

/// Sway of the body: the displacement of the centre of mass from the body trajectory that keeps the
/// zero-moment point (ZMP) inside the support triangles while single feet swing. Real-time: yes.
///
/// The support triangle is shrunk by a margin. The planned ZMP is the point of the shrunk triangle
/// that is nearest to the ZMP of the body trajectory; between two swings it moves linearly. The
/// divergent component of motion (DCM) of the sway is the bounded solution of the linear inverted
/// pendulum for the planned ZMP over the preview. Source: Englsberger, Ott, Albu-Schaeffer 2015
/// (DCM planning).
class BodySway {
 public:
  /// Motion of the body trajectory, without sway, and the limits of its ZMP.
  struct Input {
    Eigen::Vector2d p, v, a;  ///< body trajectory now, world [m], [m/s], [m/s^2]
    std::array<NextSwing, kLegs> swings;
    std::array<bool, kLegs> stance;  ///< feet that carry load now
    double shift_time;               ///< [s] time before and after a swing in which the ZMP moves
    double margin;                   ///< [m] distance of the ZMP from support edges
    VelocityChange change;           ///< of the body trajectory, part of `a`
  };

  explicit BodySway(const GaitSize& size) : size_(size) {}
  void start() noexcept { p_.setZero(), v_.setZero(), a_.setZero(); }
  void update(const Input& input, double dt) noexcept;
  bool is_at_rest() const noexcept;

  const Eigen::Vector2d& p() const noexcept { return p_; }  ///< [m] displacement, world axes
  const Eigen::Vector2d& v() const noexcept { return v_; }  ///< [m/s]
  const Eigen::Vector2d& a() const noexcept { return a_; }  ///< [m/s^2]

 private:
  GaitSize size_;
  Eigen::Vector2d p_ = Eigen::Vector2d::Zero(), v_ = p_, a_ = p_;
};

}  // namespace surefoot
