// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "estimator/filter/invariant_filter.hpp"

namespace surefoot {

/// Attitude by the gyroscope alone, from the estimate of one to two seconds ago.
///
/// Feet that were wrongly believed to stand have pulled the estimate to a wrong attitude before
/// they are refuted. They have not affected this attitude. Real-time: yes.
class AttitudeMemory {
 public:
  /// Process one tick, after the prediction of the filter.
  void update(const InvariantFilter& filter, const ImuInput& imu) noexcept;
  /// Write attitude and biases to the filter, see InvariantFilter::set_attitude().
  void restore(InvariantFilter& filter, double velocity_sigma) const noexcept;
  void reset() noexcept { *this = AttitudeMemory(); }

 private:
  struct Entry {
    Quaternion q = Quaternion::Identity();
    Vector3 gyroscope_bias = Vector3::Zero(), accelerometer_bias = Vector3::Zero();
  };
  static Entry estimate(const InvariantFilter& filter) noexcept;

  Entry old_, recent_;
  double age_ = 0.0;  // [s] since recent_ was the estimate
  bool started_ = false;
};

}  // namespace surefoot
