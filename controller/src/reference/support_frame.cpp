// SPDX-License-Identifier: BSD-3-Clause
#include "reference/support_frame.hpp"

#include <Eigen/LU>
#include <cmath>

namespace surefoot {

namespace {

constexpr double kGroundTime = 0.5;  // [s] time constant of the ground normal
// [s] after the latch in which the normal follows without delay: the estimator's attitude is still
// converging, and its corrections must not move the body.
constexpr double kInitialTime = 0.15;
constexpr double kNominalFootTime = 0.5;  // [s] time constant of the nominal foot positions
// [m^2] Keeps the normal where the feet in contact do not determine it.
constexpr double kSlopeRegularisation = 1e-4;
// [m^2] The same for update_nominal_feet(), where only the residual of the fit counts.
constexpr double kDetrendRegularisation = 1e-6;

// Compute the heading about z of the line from the centre of the rear feet to that of the front
// feet.
double heading(const FeetMatrix& p) noexcept {
  const Vector3 forward = p.col(FR_) + p.col(FL_) - p.col(RR_) - p.col(RL_);
  return std::atan2(forward.y(), forward.x());
}

Matrix3 rotation_z(double angle) noexcept {
  return exp_so3(angle * Vector3::UnitZ()).toRotationMatrix();
}

// Fit the two slopes of the heights over x and y of d by weighted least squares; both inputs have
// zero weighted mean.
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

// Apply the shortest rotation that brings the z axis of R to `normal`.
Matrix3 aligned(const Matrix3& R, const Vector3& normal) noexcept {
  return Quaternion::FromTwoVectors(R.col(2), normal).toRotationMatrix() * R;
}

}  // namespace

void SupportFrame::latch(const FeetMatrix& p) noexcept {
  time_since_latch_ = 0.0;
  origin_ = p.rowwise().mean();
  // Normal to both diagonals: that of the plane closest to the four points.
  const Vector3 normal = (p.col(FL_) - p.col(RR_)).cross(p.col(RL_) - p.col(FR_));
  R_ = rotation_z(heading(p));
  // Feet in one line span no plane: then keep the vertical.
  if (normal.norm() > 1e-3 && normal.z() > 0.0) R_ = aligned(R_, normal.normalized());
  nominal_feet_ = R_.transpose() * (p.colwise() - origin_);
  const Matrix3 turn = rotation_z(heading(nominal_feet_));
  R_ = R_ * turn;
  nominal_feet_ = turn.transpose() * nominal_feet_;
}

void SupportFrame::update(const FeetMatrix& p, const Eigen::Vector4d& contact, double dt) noexcept {
  // The offset gives all feet equal weight when all are in the air.
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

// Rotate the normal towards the slopes that fit the nominal heights to those of the feet.
void SupportFrame::update_normal(const FeetMatrix& from_mean, const FeetMatrix& nominal_feet,
                                 const Eigen::Vector4d& weight, double blend) noexcept {
  const FeetMatrix d = R_.transpose() * from_mean;
  const Eigen::Vector2d tilt =
      slope(d, d.row(2) - nominal_feet.row(2), weight, kSlopeRegularisation);
  const Vector3 normal(-tilt.x(), -tilt.y(), 1.0);
  R_ = aligned(R_, R_ * (Vector3::UnitZ() + blend * (normal - Vector3::UnitZ())).normalized());
}

// Rotate about z to the best fit of the nominal positions to the feet (planar Procrustes problem).
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

// Move the nominal positions towards the feet, and the frame so that they keep their centroid at
// the origin and their heading. A tilt that all feet share comes from the IMU or the ground and
// belongs to update_normal(); it is removed here, because the nominal positions would keep a part
// of it.
void SupportFrame::update_nominal_feet(const FeetMatrix& p, const Eigen::Vector4d& contact,
                                       const Eigen::Vector4d& weight, double dt) noexcept {
  const FeetMatrix feet = R_.transpose() * (p.colwise() - origin_);
  const FeetMatrix d = feet.colwise() - feet * weight;
  FeetMatrix moved = feet - nominal_feet_;
  moved.row(2) -=
      slope(d, moved.row(2), weight, kDetrendRegularisation).transpose() * d.topRows<2>();
  for (int leg = 0; leg < kLegs; ++leg) {
    nominal_feet_.col(leg) += contact[leg] * dt / (dt + kNominalFootTime) * moved.col(leg);
  }
  const Vector3 shift = nominal_feet_.rowwise().mean();
  const Matrix3 turn = rotation_z(heading(nominal_feet_));
  origin_ += R_ * shift;
  R_ = R_ * turn;
  nominal_feet_ = turn.transpose() * (nominal_feet_.colwise() - shift);
}

}  // namespace surefoot
