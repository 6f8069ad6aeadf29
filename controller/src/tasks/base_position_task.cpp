// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/base_position_task.hpp"

#include "tasks/position_gains.hpp"

namespace surefoot {

Vector3 base_acceleration(const Gains& gains, const Reference& reference,
                          const Dynamics& dynamics) noexcept {
  const PositionGains k(gains);
  return reference.a_base + k.kp.cwiseProduct(reference.p_base - dynamics.p_world_base()) +
         k.kd.cwiseProduct(reference.v_base - dynamics.v_world_base());
}

BodyRows base_position_task(const Gains& gains, const Vector3& acceleration,
                            const Dynamics& dynamics) noexcept {
  const Matrix3& R = dynamics.R_world_base();
  BodyRows rows;
  rows.A_base.leftCols<3>() = R;
  // Pinocchio's base acceleration a_lin is spatial. The base's origin accelerates with a_lin + w x
  // v.
  rows.b = acceleration - R * dynamics.w_base().cross(dynamics.v_base());
  rows.weight = PositionGains(gains).weight;
  return rows;
}

}  // namespace surefoot
