// SPDX-License-Identifier: BSD-3-Clause
#include "reference/stand_reference.hpp"

#include "surefoot/stage_clock.hpp"

namespace surefoot {

namespace {

// The error where it is small, ever less of it beyond `scale`.
Vector3 faded(const Vector3& error, double scale) noexcept {
  return error / (1.0 + error.squaredNorm() / (scale * scale));
}

FeetMatrix contact_points(const Dynamics& dynamics) noexcept {
  FeetMatrix p;
  for (int leg = 0; leg < kLegs; ++leg) p.col(leg) = dynamics.legs()[leg].p_world_contact;
  return p;
}

}  // namespace

void StandReference::latch(const Dynamics& dynamics, const Eigen::VectorXd& q) noexcept {
  support_.latch(contact_points(dynamics));
  const Matrix3 R = support_.R_world_support().transpose();
  const LatchedPose pose{R * (dynamics.p_world_base() - support_.origin()),
                         Quaternion(Matrix3(R * dynamics.R_world_base()))};
  motion_.latch(pose, R * (dynamics.p_world_com() - support_.origin()), q);
  com_integral_.setZero();
  base_integral_.setZero();
}

const Reference& StandReference::update(const Gains& gains, const Dynamics& dynamics,
                                        const Eigen::Vector4d& contact, double dt) noexcept {
  const StageScope stage(Stage::kReference);
  support_.update(contact_points(dynamics), contact, dt);
  const Matrix3& R = support_.R_world_support();
  motion_.step(gains, support_.places(), -R.row(2).transpose(), dt);

  reference_.p_com = support_.origin() + R * motion_.p_com();
  reference_.v_com = R * motion_.v_com();
  reference_.p_base = support_.origin() + R * motion_.p_base();
  reference_.R_world_base = Quaternion(R) * motion_.R_base();
  reference_.w_world_base = R * motion_.w_base();
  reference_.ground_normal = support_.normal();
  for (int leg = 0; leg < kLegs; ++leg) {
    reference_.feet[leg].p_world = support_.origin() + R * support_.places().col(leg);
  }
  integrate(gains, dynamics, contact.prod() * dt);
  reference_.a_com = R * com_integral_;
  reference_.alpha_world_base = R * (motion_.alpha_base() + base_integral_);
  return reference_;
}

// Integral action takes out what the model does not know: torque scale, payload, joint friction. It
// fades while the body moves or is far off, so that a push winds little up, and stops while a foot
// is off the ground (its share of time is zero).
void StandReference::integrate(const Gains& gains, const Dynamics& dynamics, double dt) noexcept {
  const Matrix3& R_world_support = support_.R_world_support();
  const double speed = dynamics.v_world_com().norm() / gains.integral_speed;
  const double fade = dt / (1.0 + speed * speed * speed * speed);
  const Vector3 com_error = reference_.p_com - dynamics.p_world_com();
  const Vector3 base_error =
      log_so3(reference_.R_world_base * Quaternion(dynamics.R_world_base()).conjugate());
  com_integral_ += fade * gains.integral_com *
                   (R_world_support.transpose() * faded(com_error, gains.integral_com_error));
  base_integral_ += fade * gains.integral_base *
                    (R_world_support.transpose() * faded(base_error, gains.integral_base_error));
  com_integral_ = com_integral_.cwiseMax(-gains.integral_com_max).cwiseMin(gains.integral_com_max);
  base_integral_ =
      base_integral_.cwiseMax(-gains.integral_base_max).cwiseMin(gains.integral_base_max);
}

}  // namespace surefoot
