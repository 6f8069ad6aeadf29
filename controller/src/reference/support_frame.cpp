// SPDX-License-Identifier: BSD-3-Clause
#include "reference/support_frame.hpp"

#include <Eigen/LU>
#include <cmath>

namespace surefoot {

namespace {

// [s] Time constant of the ground normal. Chosen longer than a push of 0.1 s, in which feet move
// without a change of the slope, and shorter than the motion of ground that tilts under the robot
// (moving_ground of surefoot.sim).
constexpr double kGroundTime = 0.5;
// [s] For this time after the latch, the ground normal follows the feet without delay. In this time
// the estimator's attitude still converges, and its corrections must not move the body. Chosen with
// robots that start on slopes (git a8e6a2e).
constexpr double kInitialTime = 0.15;
// [s] Time constant with which nominal positions follow loaded feet. Chosen equal to kGroundTime.
constexpr double kNominalFeetDriftTime = 0.5;
// [m^2] Regularisation in update_normal(). If only two feet are loaded, they do not determine the
// tilt about the line through them; with the regularisation the old tilt about this line stays.
// Numerical: small against the spread of the feet, about 0.02 m^2 (0.15 m squared).
constexpr double kSlopeRegularisation = 1e-4;
// [m^2] Regularisation in update_nominal_feet(), where only the residual of the fit is used.
// Numerical: small against the spread of the feet.
constexpr double kDetrendRegularisation = 1e-6;

// Return the heading [rad] of the line from the centre of the rear feet to the centre of the front
// feet, as the angle from the x axis about z.
double heading(const FeetMatrix& p) noexcept {
  const Vector3 forward = p.col(FR_) + p.col(FL_) - p.col(RR_) - p.col(RL_);
  return std::atan2(forward.y(), forward.x());
}

Matrix3 rotation_z(double angle) noexcept {
  return exp_so3(angle * Vector3::UnitZ()).toRotationMatrix();
}

// Return the two slopes s that best fit heights = s^T xy, by weighted least squares; xy: the first
// two rows of `d`. The columns of `d` and the heights must have zero weighted mean.
Eigen::Vector2d slope(const FeetMatrix& d, const Eigen::RowVector4d& heights,
                      const Eigen::Vector4d& weight, double regularisation) noexcept {
  Eigen::Matrix2d S = regularisation * Eigen::Matrix2d::Identity();
  Eigen::Vector2d r = Eigen::Vector2d::Zero();
  for (int leg = 0; leg < kLegs; ++leg) {
    const Eigen::Vector2d xy = d.col(leg).head<2>();
    S += weight[leg] * xy * xy.transpose();
    r += weight[leg] * heights[leg] * xy;
  }
  return S.inverse() * r;
}

// Return R after the shortest rotation that brings its z axis to `normal`.
Matrix3 align_z_axis(const Matrix3& R, const Vector3& normal) noexcept {
  return Quaternion::FromTwoVectors(R.col(2), normal).toRotationMatrix() * R;
}

}  // namespace

void SupportFrame::latch(const FeetMatrix& p) noexcept {
  time_since_latch_ = 0.0;
  origin_ = p.rowwise().mean();
  // The plane through the centre that is parallel to both diagonals of the feet is closest to the
  // four points.
  const Vector3 normal = (p.col(FL_) - p.col(RR_)).cross(p.col(RL_) - p.col(FR_));
  R_ = rotation_z(heading(p));
  // Feet in one line span no plane; the z axis then stays vertical.
  if (normal.norm() > 1e-3 && normal.z() > 0.0) R_ = align_z_axis(R_, normal.normalized());
  nominal_feet_ = R_.transpose() * (p.colwise() - origin_);
  const Matrix3 heading_rotation = rotation_z(heading(nominal_feet_));
  R_ = R_ * heading_rotation;
  nominal_feet_ = heading_rotation.transpose() * nominal_feet_;
}

void SupportFrame::update(const FeetMatrix& p, const Eigen::Vector4d& contact, double dt) noexcept {
  // The small offset gives all feet equal weight when all of them are in the air.
  Eigen::Vector4d weight = contact.cwiseMax(0.0).array() + 1e-6;
  weight /= weight.sum();
  const Vector3 mean = p * weight, mean_nominal = nominal_feet_ * weight;
  const FeetMatrix from_mean = p.colwise() - mean,
                   nominal_feet = nominal_feet_.colwise() - mean_nominal;
  time_since_latch_ += dt;
  update_normal(from_mean, nominal_feet, weight,
                time_since_latch_ < kInitialTime ? 1.0 : dt / (dt + kGroundTime));
  update_heading(from_mean, nominal_feet, weight);
  origin_ = mean - R_ * mean_nominal;
  update_nominal_feet(p, contact, weight, dt);
}

// Tilt the frame by `blend` times the tilt for which the nominal heights of the feet best fit the
// measured heights.
void SupportFrame::update_normal(const FeetMatrix& from_mean, const FeetMatrix& nominal_feet,
                                 const Eigen::Vector4d& weight, double blend) noexcept {
  const FeetMatrix d = R_.transpose() * from_mean;
  const Eigen::Vector2d tilt =
      slope(d, d.row(2) - nominal_feet.row(2), weight, kSlopeRegularisation);
  const Vector3 normal(-tilt.x(), -tilt.y(), 1.0);
  R_ = align_z_axis(R_, R_ * (Vector3::UnitZ() + blend * (normal - Vector3::UnitZ())).normalized());
}

// Rotate the frame about z so that the nominal positions fit the feet best (planar Procrustes
// problem).
void SupportFrame::update_heading(const FeetMatrix& from_mean, const FeetMatrix& nominal_feet,
                                  const Eigen::Vector4d& weight) noexcept {
  const FeetMatrix d = R_.transpose() * from_mean;
  double sine = 0.0, cosine = 0.0;
  for (int leg = 0; leg < kLegs; ++leg) {
    sine += weight[leg] * (nominal_feet(0, leg) * d(1, leg) - nominal_feet(1, leg) * d(0, leg));
    cosine += weight[leg] * (nominal_feet(0, leg) * d(0, leg) + nominal_feet(1, leg) * d(1, leg));
  }
  R_ = R_ * rotation_z(std::atan2(sine, cosine));
}

// Move the nominal positions towards the feet. Then move the frame so that its origin is again at
// the centroid of the nominal positions, and its x axis along their heading.
//
// A common tilt of all feet against the frame comes from the IMU or the ground, and update_normal()
// tilts the frame over time. The part of this tilt that remains is subtracted from the deviation,
// because otherwise the nominal positions would slowly absorb the tilt.
void SupportFrame::update_nominal_feet(const FeetMatrix& p, const Eigen::Vector4d& contact,
                                       const Eigen::Vector4d& weight, double dt) noexcept {
  const FeetMatrix feet = R_.transpose() * (p.colwise() - origin_);
  const FeetMatrix d = feet.colwise() - feet * weight;
  FeetMatrix deviation = feet - nominal_feet_;
  deviation.row(2) -=
      slope(d, deviation.row(2), weight, kDetrendRegularisation).transpose() * d.topRows<2>();
  for (int leg = 0; leg < kLegs; ++leg) {
    nominal_feet_.col(leg) += contact[leg] * dt / (dt + kNominalFeetDriftTime) * deviation.col(leg);
  }
  const Vector3 shift = nominal_feet_.rowwise().mean();
  const Matrix3 heading_rotation = rotation_z(heading(nominal_feet_));
  origin_ += R_ * shift;
  R_ = R_ * heading_rotation;
  nominal_feet_ = heading_rotation.transpose() * (nominal_feet_.colwise() - shift);
}

}  // namespace surefoot
