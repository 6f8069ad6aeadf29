// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/sole_load.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
// Half of the width of the band in which load() stays constant. Chosen: above the noise of the
// loads of a standing robot (0.01), and so small that a sole of 20 mm/weight moves by 0.4 mm.
constexpr double kBand = 0.02;
// [s] Time constant of the mean load. Chosen: a third to a half of a stance in a trot.
constexpr double kMeanTime = 0.1;
// Difference between load and mean load above which the load changes. Chosen: five times the
// errors of the loads at rest, and a fifth of the load of a trotting foot.
constexpr double kMinChange = 0.1;
// [foot radius / sqrt(s)] Random walk of the sole compliance per foot whose load changes. Chosen:
// some strides on another ground change the estimate.
constexpr double kDrift = 0.02;
}  // namespace

void SoleLoad::update(const Eigen::Vector4d& load, double dt) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    load_[leg] = std::max(0.0, std::clamp(load_[leg], load[leg] - kBand, load[leg] + kBand));
  }
  mean_ += dt / (dt + kMeanTime) * (load_ - mean_);
  for (int leg = 0; leg < kLegs; ++leg) {
    changes_[leg] = std::abs(load_[leg] - mean_[leg]) > kMinChange;
  }
}

double SoleLoad::process_variance(double radius, double dt) const noexcept {
  const auto feet = std::count(changes_.begin(), changes_.end(), true);
  return static_cast<double>(feet) * kDrift * kDrift * radius * radius * dt;
}

}  // namespace surefoot
