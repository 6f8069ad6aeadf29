// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/com_task.hpp"

#include "tasks/position_gains.hpp"

namespace surefoot {

Vector3 com_acceleration(const Gains& gains, const Reference& reference,
                         const Dynamics& dynamics) noexcept {
  const PositionGains k(gains);
  return reference.a_com + k.kp.cwiseProduct(reference.p_com - dynamics.p_world_com()) +
         k.kd.cwiseProduct(reference.v_com - dynamics.v_world_com());
}

BodyRows com_task(const Gains& gains, const Vector3& acceleration, const Vector3& f_external,
                  double mass) noexcept {
  BodyRows rows;
  for (int leg = 0; leg < kLegs; ++leg) {
    rows.A_force.middleCols<3>(3 * leg) = Matrix3::Identity() / mass;
  }
  rows.b = acceleration + kGravity * Vector3::UnitZ() - f_external / mass;
  rows.weight = PositionGains(gains).weight;
  return rows;
}

}  // namespace surefoot
