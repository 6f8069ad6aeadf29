// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "estimator/contact/foot_force_calibration.hpp"
#include "estimator/contact/force_source_check.hpp"

namespace surefoot {

/// What one tick tells of the feet's contact.
struct ContactSignals {
  Eigen::Vector4d torque_load = Eigen::Vector4d::Zero();  ///< normal force / weight, by torques
  SensorVerdict tau_est = SensorVerdict::kGood;           ///< are the torques to be had at all?
  std::array<std::int16_t, kLegs> foot_force_est{};       ///< [N]
  std::array<std::int16_t, kLegs> foot_force{};           ///< [counts]
  Eigen::Vector4d speed = Eigen::Vector4d::Zero();  ///< [m/s] of contact points, beyond the slowest
  Eigen::Vector4d clearance = Eigen::Vector4d::Zero();  ///< [m] from where each last stood
  double load_factor =
      1.0;  ///< vertical specific force / g: what the feet would bear of the weight
};

/// Belief that each foot bears load, from every source that is alive.
///
/// Sources vote, -1 .. 1, and the belief moves towards what they agree on, over the gain
/// contact_dwell: a single wrong sample moves it by one step, and two sources that contradict each
/// other leave it where it is. The torques count a little more while their sum bears out what the
/// accelerometer feels, which decides a tie, slowly. Real-time: yes.
class ContactConfidence {
 public:
  explicit ContactConfidence(double weight) : weight_(weight) {}

  void update(const Gains& gains, const ContactSignals& signals, double dt) noexcept;

  const Eigen::Vector4d& confidence() const noexcept { return confidence_; }
  /// Do the forces alone say that each foot bears, whatever its motion says? True where none
  /// speaks.
  const std::array<bool, kLegs>& loaded_by_forces() const noexcept { return loaded_by_forces_; }
  bool foot_force_est_alive() const noexcept { return force_check_.foot_force_est_alive(); }
  /// Verdicts and votes into a report.
  void write(EstimatorReport& report) const noexcept;

  void reset() noexcept { *this = ContactConfidence(weight_); }

 private:
  struct Foot {
    std::array<ContactEvidence, kContactSources> evidence{};
    StuckDetector est_stuck;
    FootForceCalibration calibration;
    double contradiction_time = 0.0;  // [s] for which footForceEst has contradicted the torques
    bool loaded = true;
    double silent_time = std::numeric_limits<double>::infinity();  // [s] since a force source spoke
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
