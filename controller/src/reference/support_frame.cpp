// SPDX-License-Identifier: BSD-3-Clause
#include "reference/support_frame.hpp"

#include <cmath>

namespace surefoot {

Matrix3 SupportFrame::R_world_support(const Vector3& smooth_normal) const noexcept {
  const Vector3 forward(std::cos(heading), std::sin(heading), 0.0);
  Matrix3 R;
  R.col(2) = smooth_normal;
  R.col(1) = smooth_normal.cross(forward).normalized();
  R.col(0) = R.col(1).cross(R.col(2));
  return R;
}

SupportFrame fit_support_frame(const FeetMatrix& p) noexcept {
  SupportFrame frame;
  frame.centroid = p.rowwise().mean();
  const Vector3 forward = p.col(FR_) + p.col(FL_) - p.col(RR_) - p.col(RL_);
  frame.heading = std::atan2(forward.y(), forward.x());
  const Vector3 normal = (p.col(FL_) - p.col(RR_)).cross(p.col(RL_) - p.col(FR_));
  // Feet in one line span no plane: keep the vertical.
  if (normal.norm() > 1e-3 && normal.z() > 0.0) frame.normal = normal.normalized();
  return frame;
}

}  // namespace surefoot
