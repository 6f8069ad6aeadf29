// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/estimator_impl.hpp"

namespace surefoot {

namespace {

using Covariance = Eigen::Matrix<double, 15, 15>;

// Convert the covariance of the filter's error xi to the covariance of plain errors
// (estimate minus true value) of the base. xi is the error on the group, of the IMU point. To first
// order, a vector x of the state has the plain error x_estimate - x = xi_x + xi_R x x.
Covariance base_covariance(const InvariantFilter& filter, const Vector3& p_base,
                           const Vector3& v_base, const Vector3& p_base_imu) noexcept {
  constexpr int kParts[] = {error_index::kRotation, error_index::kVelocity, error_index::kPosition,
                            error_index::kGyroscopeBias, error_index::kAccelerometerBias};
  Covariance P;
  for (int a = 0; a < 5; ++a) {
    for (int b = 0; b < 5; ++b) {
      for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
          P(3 * a + i, 3 * b + k) = filter.covariance()(kParts[a] + i, kParts[b] + k);
        }
      }
    }
  }
  Covariance T = Covariance::Identity();
  T.block<3, 3>(3, 0) = -skew(v_base);
  T.block<3, 3>(6, 0) = -skew(p_base);
  // v_base = v_imu - w x arm: an error of the gyroscope bias enters through w.
  T.block<3, 3>(3, 9) = -filter.R_world_base() * skew(p_base_imu);
  return T * P * T.transpose();
}

}  // namespace

EstimatorReport StateEstimator::report() const noexcept {
  const Impl& s = *impl_;
  EstimatorReport out;
  out.gyroscope = s.imu.gyroscope;
  out.accelerometer = s.imu.accelerometer;
  out.quaternion = s.quaternion_check.verdict();
  s.contact.write(out);
  out.foot_forces_from_torques = s.leg_forces.forces();
  out.slip = s.slip.slip();
  out.friction = s.friction.coefficient();
  out.armature = s.robot.config().armature + s.joints.armature_error();
  out.joint_damping = s.joints.damping();
  out.joint_friction = s.joints.friction();
  out.gyroscope_bias = s.filter.gyroscope_bias();
  out.accelerometer_bias = s.filter.accelerometer_bias();
  const Vector3 v_base = s.dynamics.R_world_base() * s.state.v.head<3>();
  out.covariance =
      base_covariance(s.filter, s.state.q.head<3>(), v_base, s.robot.config().p_base_imu);
  // Wrong leg lengths cause the same relative position error in every step. The white noise of the
  // filter does not model such an error, so the square of leg_scale times the path length is added.
  const double scale_error = s.gains.leg_scale * s.path_length;
  out.covariance.diagonal().segment<3>(6).array() += scale_error * scale_error;
  out.nis = s.filter.nis();
  out.nis_dimension = s.filter.nis_dimension();
  out.rejected_feet = s.filter.rejected_feet();
  out.sole_compliance = s.filter.sole_compliance();
  out.f_sustained = s.payload.force();
  out.moment_external = s.payload.moment();
  out.payload = s.payload.mass();
  out.com_shift = s.dynamics.R_world_base().transpose() * s.payload.com_shift();
  return out;
}

}  // namespace surefoot
