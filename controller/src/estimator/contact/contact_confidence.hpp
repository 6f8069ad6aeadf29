// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "estimator/contact/foot_force_calibration.hpp"
#include "estimator/contact/force_source_check.hpp"

namespace surefoot {

/// Measurements of one tick that show the contact of the feet.
struct ContactSignals {
  Eigen::Vector4d torque_load = Eigen::Vector4d::Zero();  ///< normal force / weight, by torques
  SensorVerdict tau_est = SensorVerdict::kGood;           ///< verdict on the joint torques
  std::array<std::int16_t, kLegs> foot_force_est{};       ///< [N]
  std::array<std::int16_t, kLegs> foot_force{};           ///< [counts]
  Eigen::Vector4d speed = Eigen::Vector4d::Zero();        ///< [m/s] see excess_speed()
  Eigen::Vector4d clearance = Eigen::Vector4d::Zero();    ///< [m] see FootClearance
  /// Vertical specific force / g: sum of the loads / weight of a robot on its feet.
  double load_factor = 1.0;
};

/// Contact confidence of each foot, fused from all working contact sources.
///
/// Each source votes from -1 (off the ground) to 1 (loaded). The confidence integrates the weighted
/// mean vote; when all agree it moves from 0 to 1 within the gain contact_dwell. So a single wrong
/// sample changes it by one step only, and two sources that contradict each other leave it
/// unchanged. Torques have a slightly larger weight while their sum matches the accelerometer; this
/// breaks ties, slowly. Real-time: yes.
class ContactConfidence {
 public:
  explicit ContactConfidence(double weight) : weight_(weight) {}

  /// Process one tick.
  void update(const Gains& gains, const ContactSignals& signals, double dt) noexcept;

  const Eigen::Vector4d& confidence() const noexcept { return confidence_; }
  /// Whether the force sources alone show each foot as loaded; true if none is available.
  const std::array<bool, kLegs>& loaded_by_forces() const noexcept { return loaded_by_forces_; }
  bool foot_force_est_works() const noexcept { return force_check_.foot_force_est_works(); }
  /// Write verdicts and votes to a report.
  void write(EstimatorReport& report) const noexcept;

  void reset() noexcept { *this = ContactConfidence(weight_); }

 private:
  struct Foot {
    std::array<ContactEvidence, kContactSources> evidence{};
    StuckDetector est_stuck;
    FootForceCalibration calibration;
    double contradiction_time = 0.0;  // [s] footForceEst against torques, leaky
    bool loaded = true;
    double no_force_time =
        std::numeric_limits<double>::infinity();  // [s] since the last force vote
  };
  ContactEvidence foot_force_est_evidence(const Gains& gains, const ContactSignals& signals,
                                          int leg, double dt) noexcept;
  void fuse_votes(const Gains& gains, const ContactSignals& signals, int leg, double dt) noexcept;

  double weight_;
  ForceSourceCheck force_check_;
  std::array<Foot, kLegs> feet_{};
  Eigen::Vector4d confidence_ = Eigen::Vector4d::Ones();
  std::array<bool, kLegs> loaded_by_forces_{true, true, true, true};
};

}  // namespace surefoot
