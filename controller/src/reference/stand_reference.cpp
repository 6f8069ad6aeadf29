// SPDX-License-Identifier: BSD-3-Clause
#include "reference/stand_reference.hpp"

namespace surefoot {

namespace {

constexpr double kGroundTime = 0.5;  // [s] how slowly the ground's normal follows the feet
constexpr double kAnchorTime = 0.5;  // [s] how slowly an anchor follows a foot that has moved

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

void StandReference::latch(const Dynamics& dynamics) noexcept {
  const FeetMatrix p = contact_points(dynamics);
  const SupportFrame support = fit_support_frame(p);
  const Matrix3 R = support.R_world_support(support.normal);
  com_from_centroid_ = R.transpose() * (dynamics.p_world_com() - support.centroid);
  R_support_base_ = Quaternion(Matrix3(R.transpose() * dynamics.R_world_base()));
  anchors_ = R.transpose() * (p.colwise() - support.centroid);
  normal_ = support.normal;
  com_integral_.setZero();
  base_integral_.setZero();
}

const Reference& StandReference::update(const Gains& gains, const Dynamics& dynamics,
                                        const Eigen::Vector4d& contact, double dt) noexcept {
  const SupportFrame support = fit_support_frame(contact_points(dynamics));
  follow_ground(support, contact, dt);
  const Matrix3 R = support.R_world_support(normal_);
  follow_moved_feet(support, R, dynamics, contact, dt);

  reference_.p_com = support.centroid + R * com_from_centroid_;
  reference_.R_world_base = Quaternion(R) * R_support_base_;
  reference_.ground_normal = normal_;
  for (int leg = 0; leg < kLegs; ++leg) {
    reference_.feet[leg].p_world = support.centroid + R * anchors_.col(leg);
  }
  integrate(gains, dynamics, R, contact.prod() * dt);
  reference_.a_com = R * com_integral_;
  reference_.alpha_world_base = R * base_integral_;
  return reference_;
}

// A lifted foot must not tilt the ground: believe the plane only as far as all four stand on it.
void StandReference::follow_ground(const SupportFrame& support, const Eigen::Vector4d& contact,
                                   double dt) noexcept {
  const double blend = contact.prod() * dt / (dt + kGroundTime);
  normal_ = (normal_ + blend * (support.normal - normal_)).normalized();
}

void StandReference::follow_moved_feet(const SupportFrame& support, const Matrix3& R_world_support,
                                       const Dynamics& dynamics, const Eigen::Vector4d& contact,
                                       double dt) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    const Vector3 place =
        R_world_support.transpose() * (dynamics.legs()[leg].p_world_contact - support.centroid);
    anchors_.col(leg) += contact[leg] * dt / (dt + kAnchorTime) * (place - anchors_.col(leg));
  }
}

// Integral action takes out what the model does not know: torque scale, payload, joint friction. It
// fades while the body moves or is far off, so that a push winds little up, and stops while a foot
// is off the ground (its share of time is zero).
void StandReference::integrate(const Gains& gains, const Dynamics& dynamics,
                               const Matrix3& R_world_support, double dt) noexcept {
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
