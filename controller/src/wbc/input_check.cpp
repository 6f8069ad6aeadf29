// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/input_check.hpp"

namespace surefoot {

namespace {

// Tolerance of the norm of unit quaternions and ground normals. Numerical: above the rounding of a
// float, 1e-7. The QP assumes a norm of 1, so the tolerance also bounds the error of this
// assumption.
constexpr double kUnitTolerance = 1e-3;

bool finite(const Reference& r) noexcept {
  bool all_finite = r.p_com.allFinite() && r.v_com.allFinite() && r.a_com.allFinite() &&
                    r.p_base.allFinite() && r.v_base.allFinite() && r.a_base.allFinite() &&
                    r.R_world_base.coeffs().allFinite() && r.w_world_base.allFinite() &&
                    r.alpha_world_base.allFinite() && r.L_com.allFinite() &&
                    r.Ldot_com.allFinite() && r.posture.allFinite() && r.ground_normal.allFinite();
  for (const FootReference& foot : r.feet) {
    all_finite = all_finite && foot.p_world.allFinite() && foot.v_world.allFinite() &&
                 foot.a_world.allFinite() && foot.f_world.allFinite() && std::isfinite(foot.load) &&
                 std::isfinite(foot.min_contact);
  }
  return all_finite;
}

}  // namespace

Status check_state(const RobotState& state, const Robot& robot) noexcept {
  if (state.q.size() != robot.nq() || state.v.size() != robot.nv()) return Status::kWrongSize;
  if (!state.q.allFinite() || !state.v.allFinite() || !state.contact.allFinite() ||
      !state.f_external.allFinite() || !state.f_sustained.allFinite() ||
      !state.moment_external.allFinite() || !state.friction.allFinite() ||
      !state.armature_error.allFinite() || !state.joint_damping.allFinite() ||
      !state.joint_friction.allFinite()) {
    return Status::kNonFinite;
  }
  const auto in_unit_range = [](const Eigen::Vector4d& x) {
    return x.minCoeff() >= 0.0 && x.maxCoeff() <= 1.0;
  };
  if (!in_unit_range(state.contact) || !in_unit_range(state.friction)) {
    return Status::kImplausible;
  }
  if ((robot.config().armature + state.armature_error).minCoeff() < 0.0 ||
      state.joint_damping.minCoeff() < 0.0 || state.joint_friction.minCoeff() < 0.0) {
    return Status::kImplausible;
  }
  const double norm = state.q.segment<4>(3).norm();
  return std::abs(norm - 1.0) > kUnitTolerance ? Status::kBadQuaternion : Status::kOk;
}

Status check_reference(const Reference& r, const Robot& robot) noexcept {
  if (r.posture.size() != 0 && r.posture.size() != robot.nv() - 6) return Status::kWrongSize;
  if (!finite(r)) return Status::kNonFinite;
  const bool valid = std::abs(r.R_world_base.norm() - 1.0) <= kUnitTolerance &&
                     std::abs(r.ground_normal.norm() - 1.0) <= kUnitTolerance &&
                     r.ground_normal.z() > 0.1;  // an almost horizontal normal is an error
  return valid ? Status::kOk : Status::kBadReference;
}

}  // namespace surefoot
