// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/sole_load.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
// Half of the width of the band in which load() stays constant while no foot steps. Chosen: above
// the noise of the loads of a standing robot (0.01), and so small that a sole of 20 mm/weight moves
// by 0.4 mm.
constexpr double kBand = 0.02;
// [s] Time by which the sink of a sole may lead or lag the measured load: damping of the sole,
// filter of the forces, delays. The sink may be wrong by the change of the load in this time.
constexpr double kLag = 0.01;
// [s] Time for which an error of the sink lasts. The filter assumes errors that are independent
// from tick to tick, so the variance is larger by the number of ticks in this time. Chosen: about
// the time in which the load of a foot rises.
constexpr double kErrorTime = 0.04;
// [s] Time constant of the mean load. Chosen: a third to a half of a stance in a trot.
constexpr double kMeanTime = 0.1;
// Difference between load and mean load above which the load changes. Chosen: a
// third of the load of a trotting foot. With 0.1, the collapse of a b1 on rigid soles left a
// compliance of 0.8 mm, and with 0.11 or 0.12 a frozen joint angle of a go1 was named late.
constexpr double kMinChange = 0.15;
// [foot radius / sqrt(s)] Random walk of the sole compliance of a robot that steps, per foot whose
// load changes. Chosen: some strides on another ground change the estimate.
constexpr double kDrift = 0.02;
}  // namespace

void SoleLoad::update(const Eigen::Vector4d& load, bool steps, double dt) noexcept {
  steps_ = steps;
  const double band = steps ? 0.0 : kBand;
  for (int leg = 0; leg < kLegs; ++leg) {
    load_[leg] = std::max(0.0, std::clamp(load_[leg], load[leg] - band, load[leg] + band));
  }
  lagged_ += dt / (dt + kLag) * (load_ - lagged_);
  mean_ += dt / (dt + kMeanTime) * (load_ - mean_);
  for (int leg = 0; leg < kLegs; ++leg) {
    changes_[leg] = std::abs(load_[leg] - mean_[leg]) > kMinChange;
  }
}

Eigen::Vector4d SoleLoad::sink_variance(double compliance, double dt) const noexcept {
  const Eigen::Vector4d change = compliance * (load_ - lagged_);
  return kErrorTime / dt * change.array().square();
}

double SoleLoad::process_variance(double radius, double dt) const noexcept {
  if (!steps_) return 0.0;
  const auto feet = std::count(changes_.begin(), changes_.end(), true);
  return static_cast<double>(feet) * kDrift * kDrift * radius * radius * dt;
}

}  // namespace surefoot
