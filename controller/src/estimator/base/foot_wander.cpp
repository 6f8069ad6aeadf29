// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/base/foot_wander.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
constexpr double kSmooth = 0.01;        // [s] keeps the encoders' noise out of speeds
constexpr double kNoisePeriod = 0.002;  // [s] the sampling that the noise gains are quoted at
constexpr double kSwingSpeed = 3.0;     // [m/s] how fast a foot off the ground may move
constexpr double kSwingShare = 3.0;     // of its speed relative to the base, besides
constexpr double kSwingTime = 0.1;      // [s] for which it goes on like that
constexpr double kLight = 0.03;         // share of the weight that keeps a foot where it is
constexpr double kLightSpeed = 0.5;     // [m/s] at which one without may slide
}  // namespace

void FootWander::see(const Dynamics& dynamics, double dt) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    v_.col(leg) += dt / (dt + kSmooth) * (dynamics.legs()[leg].v_world_contact - v_.col(leg));
  }
}

FeetMatrix FootWander::roll(const Dynamics& dynamics, const Vector12& q,
                            const Eigen::Vector4d& contact, const Vector3& lever,
                            double dt) noexcept {
  const Vector12 bent = q - q_;
  q_ = q;
  if (!called_) {
    called_ = true;
    return FeetMatrix::Zero();
  }
  const Vector3 turned = dt * dynamics.w_world_base();
  FeetMatrix way;
  for (int leg = 0; leg < kLegs; ++leg) {
    const Vector3 turn = turned + dynamics.legs()[leg].axes_world * bent.segment<3>(3 * leg);
    way.col(leg) = contact[leg] * turn.cross(lever);
  }
  return way;
}

Eigen::Vector4d FootWander::variance(const Gains& gains, const FootBeliefs& beliefs,
                                     double dt) const noexcept {
  Eigen::Vector4d out;
  for (int leg = 0; leg < kLegs; ++leg) {
    const double doubt = beliefs.refused[leg] ? 1.0 : 1.0 - beliefs.contact[leg];
    const double light = std::exp(-std::max(beliefs.load[leg], 0.0) / kLight);
    const double moving = v_.col(leg).norm();
    const double slide = gains.noise_foot_slip + gains.noise_foot_motion * moving +
                         light * kLightSpeed + beliefs.slip[leg];
    const double swing = doubt * doubt * (kSwingSpeed + kSwingShare * moving);
    out[leg] = (slide * slide * kNoisePeriod + swing * swing * kSwingTime) * dt;
  }
  return out;
}

}  // namespace surefoot
