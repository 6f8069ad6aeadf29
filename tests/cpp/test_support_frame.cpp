// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "reference/support_frame.hpp"

using namespace surefoot;

namespace {

constexpr double kDt = 0.002;
const Eigen::Vector4d kAllLoaded = Eigen::Vector4d::Ones();

// Feet of a robot with its heading to the left; one foot stands on a stone.
struct SupportFrameFixture {
  FeetMatrix feet;
  SupportFrame frame;
  SupportFrameFixture() {
    feet << 0.20, 0.18, -0.19, -0.20,  //
        -0.13, 0.13, -0.12, 0.14,      //
        0.0, 0.0, 0.02, 0.0;
    feet = moved(feet, Vector3(1.0, -2.0, 0.1), exp_so3(Vector3(0, 0, 0.4)));
    frame.latch(feet);
  }
  static FeetMatrix moved(const FeetMatrix& p, const Vector3& shift, const Quaternion& R) {
    return (R.toRotationMatrix() * p).colwise() + shift;
  }
  FeetMatrix p_world_nominal_feet() const {
    return (frame.R_world_support() * frame.nominal_feet()).colwise() + frame.origin();
  }
  double position_error(const FeetMatrix& p) const { return (p_world_nominal_feet() - p).norm(); }
  void stand(const FeetMatrix& p, const Eigen::Vector4d& contact, double seconds) {
    for (int k = 0; k < seconds / kDt; ++k) frame.update(p, contact, kDt);
  }
};

double angle_between(const Matrix3& a, const Matrix3& b) {
  return log_so3(Quaternion(Matrix3(a.transpose() * b))).norm();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(support_frame)

BOOST_FIXTURE_TEST_CASE(frame_is_centred_between_the_feet_and_points_forward, SupportFrameFixture) {
  BOOST_TEST((frame.origin() - Vector3(feet.rowwise().mean())).norm() < 1e-12);
  BOOST_TEST(position_error(feet) < 1e-12);
  const Vector3 forward = frame.nominal_feet().col(FR_) + frame.nominal_feet().col(FL_) -
                          frame.nominal_feet().col(RR_) - frame.nominal_feet().col(RL_);
  BOOST_TEST(std::abs(std::atan2(forward.y(), forward.x())) < 1e-9);
  BOOST_TEST(forward.x() > 0.0);
  // Its plane fits the feet best: their heights have no slope left.
  const Eigen::Vector2d left =
      frame.nominal_feet().topRows<2>() * frame.nominal_feet().row(2).transpose();
  BOOST_TEST(left.norm() < 2e-4);
}

BOOST_FIXTURE_TEST_CASE(stationary_feet_keep_the_frame_stationary, SupportFrameFixture) {
  const SupportFrame before = frame;
  stand(feet, kAllLoaded, 5.0);
  BOOST_TEST((frame.origin() - before.origin()).norm() < 1e-12);
  BOOST_TEST(angle_between(frame.R_world_support(), before.R_world_support()) < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(frame_follows_position_and_yaw_drift_at_once, SupportFrameFixture) {
  const Quaternion yaw = exp_so3(Vector3(0.0, 0.0, 0.7));
  const Vector3 shift(5.0, -3.0, 0.4);
  // For a turn about a vertical axis, this is exact at once only if the frame's normal is vertical.
  FeetMatrix level = feet;
  level.row(2).setConstant(0.1);
  frame.latch(level);
  const SupportFrame before = frame;
  frame.update(moved(level, shift, yaw), kAllLoaded, kDt);
  BOOST_TEST((frame.origin() - (yaw * before.origin() + shift)).norm() < 1e-12);
  BOOST_TEST(angle_between(frame.R_world_support(),
                           yaw.toRotationMatrix() * before.R_world_support()) < 1e-9);
  BOOST_TEST((frame.nominal_feet() - before.nominal_feet()).norm() < 1e-12);
}

BOOST_FIXTURE_TEST_CASE(lifted_foot_moved_10_cm_does_not_move_the_frame, SupportFrameFixture) {
  const SupportFrame before = frame;
  FeetMatrix lifted = feet;
  lifted.col(FL_) += Vector3(0.06, 0.0, 0.08);
  stand(lifted, Eigen::Vector4d(1, 0, 1, 1), 3.0);
  // A foot without contact has a weight of 1e-6.
  BOOST_TEST((frame.origin() - before.origin()).norm() < 1e-6);
  BOOST_TEST(angle_between(frame.R_world_support(), before.R_world_support()) < 1e-5);
  BOOST_TEST((frame.nominal_feet() - before.nominal_feet()).norm() < 1e-6);
}

BOOST_FIXTURE_TEST_CASE(nominal_position_slowly_follows_a_displaced_stance_foot,
                        SupportFrameFixture) {
  FeetMatrix stepped = feet;
  stepped.col(RR_) += Vector3(0.03, 0.02, 0.0);
  frame.update(stepped, kAllLoaded, kDt);
  const double at_first = position_error(stepped);
  // One of four feet moves the frame by its share of the step only.
  BOOST_TEST(at_first > 0.4 * 0.036);
  stand(stepped, kAllLoaded, 0.5);
  BOOST_TEST(position_error(stepped) < 0.5 * at_first);
  BOOST_TEST(position_error(stepped) > 0.25 * at_first);
  stand(stepped, kAllLoaded, 10.0);
  BOOST_TEST(position_error(stepped) < 1e-6);
  BOOST_TEST((frame.origin() - Vector3(stepped.rowwise().mean())).norm() < 1e-6);
}

BOOST_FIXTURE_TEST_CASE(frame_follows_attitude_at_once_while_the_estimate_converges,
                        SupportFrameFixture) {
  const SupportFrame before = frame;
  const Quaternion tilt = exp_so3(Vector3(0.02, -0.01, 0.0));
  for (int k = 1; k <= 20; ++k) {
    const Quaternion so_far = Quaternion::Identity().slerp(k / 20.0, tilt);
    frame.update(moved(feet, Vector3::Zero(), so_far), kAllLoaded, kDt);
  }
  BOOST_TEST(angle_between(frame.R_world_support(),
                           tilt.toRotationMatrix() * before.R_world_support()) < 1e-3);
}

BOOST_FIXTURE_TEST_CASE(frame_follows_tilting_ground_within_10_s, SupportFrameFixture) {
  stand(feet, kAllLoaded, 0.3);
  const SupportFrame before = frame;
  const Quaternion tilt = exp_so3(Vector3(0.1, -0.05, 0.0));
  const FeetMatrix tilted = moved(feet, Vector3::Zero(), tilt);
  frame.update(tilted, kAllLoaded, kDt);
  BOOST_TEST(angle_between(frame.R_world_support(),
                           tilt.toRotationMatrix() * before.R_world_support()) > 0.1);
  stand(tilted, kAllLoaded, 10.0);
  const Vector3 expected = tilt * before.normal();
  BOOST_TEST((frame.normal() - expected).norm() < 1e-5);
  BOOST_TEST((frame.nominal_feet() - before.nominal_feet()).norm() < 1e-4);
  BOOST_TEST(position_error(tilted) < 1e-4);
}

BOOST_FIXTURE_TEST_CASE(frame_normal_equals_the_slope_normal, SupportFrameFixture) {
  const Quaternion slope = exp_so3(Vector3(0.2, 0.1, 0.0));
  FeetMatrix level = feet;
  level.row(2).setConstant(0.1);
  frame.latch(moved(level, Vector3::Zero(), slope));
  BOOST_TEST((frame.normal() - slope * Vector3::UnitZ()).norm() < 1e-9);
  BOOST_TEST(frame.nominal_feet().row(2).cwiseAbs().maxCoeff() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(frame_stays_finite_without_contact_and_with_collinear_feet,
                        SupportFrameFixture) {
  stand(feet, Eigen::Vector4d::Zero(), 1.0);
  BOOST_TEST(position_error(feet) < 1e-6);
  FeetMatrix line = feet;
  line.row(1) = 0.5 * line.row(0);
  line.row(2).setZero();
  frame.latch(line);
  BOOST_TEST((frame.normal() - Vector3::UnitZ()).norm() < 1e-9);
  stand(line, Eigen::Vector4d(1, 0, 0, 1), 1.0);
  BOOST_TEST(frame.R_world_support().allFinite());
  BOOST_TEST(
      (frame.R_world_support() * frame.R_world_support().transpose() - Matrix3::Identity()).norm() <
      1e-9);
}

BOOST_AUTO_TEST_SUITE_END()
