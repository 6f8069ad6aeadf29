// SPDX-License-Identifier: BSD-3-Clause
#include "reference/support_frame.hpp"

#include <cmath>

namespace surefoot {

Matrix3 SupportFrame::R_world_heading() const noexcept {
  return Eigen::AngleAxisd(heading, Vector3::UnitZ()).toRotationMatrix();
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
