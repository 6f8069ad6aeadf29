// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/com_task.hpp"

namespace surefoot {

Vector3 com_acceleration(const Gains& gains, const Reference& reference,
                         const Dynamics& dynamics) noexcept {
  const Vector3 kp(gains.com_kp_horizontal, gains.com_kp_horizontal, gains.com_kp_vertical);
  const Vector3 kd(gains.com_kd_horizontal, gains.com_kd_horizontal, gains.com_kd_vertical);
  return reference.a_com + kp.cwiseProduct(reference.p_com - dynamics.p_world_com()) +
         kd.cwiseProduct(reference.v_com - dynamics.v_world_com());
}

TaskRows com_task(const Gains& gains, const Vector3& acceleration, double mass) noexcept {
  TaskRows rows;
  for (int leg = 0; leg < kLegs; ++leg) {
    rows.A.middleCols<3>(3 * leg) = Matrix3::Identity() / mass;
  }
  rows.b = acceleration + kGravity * Vector3::UnitZ();
  rows.weight << gains.weight_com_horizontal, gains.weight_com_horizontal,
      gains.weight_com_vertical;
  return rows;
}

}  // namespace surefoot
