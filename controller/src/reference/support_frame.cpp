// SPDX-License-Identifier: BSD-3-Clause
#include "reference/support_frame.hpp"

#include <Eigen/LU>
#include <cmath>

namespace surefoot {

namespace {

constexpr double kGroundTime = 0.5;  // [s] how slowly the ground's normal follows the feet
// [s] for which it follows at once: the attitude is still being found, and what it finds out about
// the vertical is no reason to move.
constexpr double kFinding = 0.15;
constexpr double kPlaceTime = 0.5;  // [s] how slowly a place follows a foot that has moved
constexpr double kStiff = 1e-4;     // [m^2] keeps the normal where the feet in contact do not say
constexpr double kUntilted = 1e-6;  // [m^2] the same, where only what is left over counts

// Heading of the line from the rear feet's middle to the front's, about z.
double heading(const FeetMatrix& p) noexcept {
  const Vector3 forward = p.col(FR_) + p.col(FL_) - p.col(RR_) - p.col(RL_);
  return std::atan2(forward.y(), forward.x());
}

Matrix3 about_z(double angle) noexcept {
  return exp_so3(angle * Vector3::UnitZ()).toRotationMatrix();
}

// Least squares for the two slopes of heights over d's x and y, both about their weighted mean.
Eigen::Vector2d slope(const FeetMatrix& d, const Eigen::RowVector4d& heights,
                      const Eigen::Vector4d& weight, double stiff) noexcept {
  Eigen::Matrix2d S = stiff * Eigen::Matrix2d::Identity();
  Eigen::Vector2d r = Eigen::Vector2d::Zero();
  for (int leg = 0; leg < kLegs; ++leg) {
    const Eigen::Vector2d xy = d.col(leg).head<2>();
    S += weight[leg] * xy * xy.transpose();
    r += weight[leg] * heights[leg] * xy;
  }
  return S.inverse() * r;
}

// Shortest rotation that brings R's third axis to `normal`.
Matrix3 aligned(const Matrix3& R, const Vector3& normal) noexcept {
  return Quaternion::FromTwoVectors(R.col(2), normal).toRotationMatrix() * R;
}

}  // namespace

void SupportFrame::latch(const FeetMatrix& p) noexcept {
  age_ = 0.0;
  origin_ = p.rowwise().mean();
  // Normal to both diagonals: of the plane closest to the four points.
  const Vector3 normal = (p.col(FL_) - p.col(RR_)).cross(p.col(RL_) - p.col(FR_));
  R_ = about_z(heading(p));
  // Feet in one line span no plane: keep the vertical.
  if (normal.norm() > 1e-3 && normal.z() > 0.0) R_ = aligned(R_, normal.normalized());
  places_ = R_.transpose() * (p.colwise() - origin_);
  const Matrix3 turn = about_z(heading(places_));
  R_ = R_ * turn;
  places_ = turn.transpose() * places_;
}

void SupportFrame::update(const FeetMatrix& p, const Eigen::Vector4d& contact, double dt) noexcept {
  // All in the air: nothing says more than the shape of the feet as a whole.
  Eigen::Vector4d weight = contact.cwiseMax(0.0).array() + 1e-6;
  weight /= weight.sum();
  const Vector3 mean = p * weight, mean_place = places_ * weight;
  const FeetMatrix from_mean = p.colwise() - mean, places = places_.colwise() - mean_place;
  age_ += dt;
  tilt(from_mean, places, weight, age_ < kFinding ? 1.0 : dt / (dt + kGroundTime));
  turn(from_mean, places, weight);
  origin_ = mean - R_ * mean_place;
  follow_moved_feet(p, contact, weight, dt);
}

// Towards the two slopes that bring the places' heights to the feet's.
void SupportFrame::tilt(const FeetMatrix& from_mean, const FeetMatrix& places,
                        const Eigen::Vector4d& weight, double blend) noexcept {
  const FeetMatrix d = R_.transpose() * from_mean;
  const Eigen::Vector2d tilt = slope(d, d.row(2) - places.row(2), weight, kStiff);
  const Vector3 normal(-tilt.x(), -tilt.y(), 1.0);
  R_ = aligned(R_, R_ * (Vector3::UnitZ() + blend * (normal - Vector3::UnitZ())).normalized());
}

// The turn about z that fits the places to the feet best (Procrustes in the plane).
void SupportFrame::turn(const FeetMatrix& from_mean, const FeetMatrix& places,
                        const Eigen::Vector4d& weight) noexcept {
  const FeetMatrix d = R_.transpose() * from_mean;
  double sine = 0.0, cosine = 0.0;
  for (int leg = 0; leg < kLegs; ++leg) {
    sine += weight[leg] * (places(0, leg) * d(1, leg) - places(1, leg) * d(0, leg));
    cosine += weight[leg] * (places(0, leg) * d(0, leg) + places(1, leg) * d(1, leg));
  }
  R_ = R_ * about_z(std::atan2(sine, cosine));
}

// A foot's place follows it, and the frame moves so that the places keep their centroid at its
// origin and their heading. What tilts all feet alike is the IMU's or the ground's: it belongs to
// tilt(), and places that took it in would keep a share of it for good.
void SupportFrame::follow_moved_feet(const FeetMatrix& p, const Eigen::Vector4d& contact,
                                     const Eigen::Vector4d& weight, double dt) noexcept {
  const FeetMatrix now = R_.transpose() * (p.colwise() - origin_);
  const FeetMatrix d = now.colwise() - now * weight;
  FeetMatrix moved = now - places_;
  moved.row(2) -= slope(d, moved.row(2), weight, kUntilted).transpose() * d.topRows<2>();
  for (int leg = 0; leg < kLegs; ++leg) {
    places_.col(leg) += contact[leg] * dt / (dt + kPlaceTime) * moved.col(leg);
  }
  const Vector3 shift = places_.rowwise().mean();
  const Matrix3 turn = about_z(heading(places_));
  origin_ += R_ * shift;
  R_ = R_ * turn;
  places_ = turn.transpose() * (places_.colwise() - shift);
}

}  // namespace surefoot
