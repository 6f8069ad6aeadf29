// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/base_orientation_task.hpp"

namespace surefoot {

Vector3 base_angular_acceleration(const Gains& gains, const Reference& reference,
                                  const Dynamics& dynamics) noexcept {
  const Quaternion R_world_base(dynamics.R_world_base());
  const Vector3 error = log_so3(reference.R_world_base * R_world_base.conjugate());
  const Vector3 kp(gains.base_kp_tilt, gains.base_kp_tilt, gains.base_kp_yaw);
  const Vector3 kd(gains.base_kd_tilt, gains.base_kd_tilt, gains.base_kd_yaw);
  return reference.alpha_world_base + kp.cwiseProduct(error) +
         kd.cwiseProduct(reference.w_world_base - dynamics.w_world_base());
}

BodyRows base_orientation_task(const Gains& gains, const Vector3& angular_acceleration_world,
                               const Dynamics& dynamics, bool stepping) noexcept {
  BodyRows rows;
  rows.A_base.rightCols<3>() = dynamics.R_world_base();
  rows.b = angular_acceleration_world;
  rows.weight << gains.weight_base_tilt, gains.weight_base_tilt, gains.weight_base_yaw;
  if (stepping) rows.weight.setConstant(gains.walk_weight_base_rotation);
  return rows;
}

}  // namespace surefoot
