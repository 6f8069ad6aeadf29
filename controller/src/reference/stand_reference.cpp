// SPDX-License-Identifier: BSD-3-Clause
#include "reference/stand_reference.hpp"

#include "surefoot/stage_clock.hpp"

namespace surefoot {

namespace {

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
  reference_.alpha_world_base = R * motion_.alpha_base();
  return reference_;
}

}  // namespace surefoot
