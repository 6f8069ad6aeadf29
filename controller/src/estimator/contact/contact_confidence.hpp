// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "estimator/contact/foot_force_calibration.hpp"
#include "estimator/contact/force_source_check.hpp"

namespace surefoot {

/// Measurements of one tick from which contact is judged. Legs in the order FR FL RR RL.
struct ContactSignals {
  /// Load / weight of each foot, from joint torques.
  Eigen::Vector4d torque_load = Eigen::Vector4d::Zero();
  SensorVerdict tau_est = SensorVerdict::kGood;         ///< verdict on the joint torques
  std::array<std::int16_t, kLegs> foot_force_est{};     ///< [N]
  std::array<std::int16_t, kLegs> foot_force{};         ///< [counts]
  Eigen::Vector4d speed = Eigen::Vector4d::Zero();      ///< [m/s] SlipDetector::excess_speed()
  Eigen::Vector4d clearance = Eigen::Vector4d::Zero();  ///< [m] see FootClearance
  /// Vertical specific force / g. For a robot on its feet it equals the sum of the normal forces,
  /// divided by the weight.
  double load_factor = 1.0;
  bool steps = false;             ///< true: the robot steps, see StepDetector
  bool standing_refuted = false;  ///< see StandingCheck
};

/// Contact confidence of each foot, fused from all working contact sources.
///
/// Each source votes from -1 (off the ground) to 1 (loaded). The confidence integrates the weighted
/// mean vote. If all sources agree, the confidence moves from 0 to 1 within the gain contact_dwell,
/// and in 0.4 times that while the robot steps.
/// So a single wrong sample changes the confidence by one step only, and two sources that
/// contradict each other leave it unchanged. Exception: while the sum of the loads from the torques
/// matches the accelerometer, the torques have a slightly larger weight. A contradiction is then
/// slowly decided in favour of the torques. Real-time: yes.
class ContactConfidence {
 public:
  /// @param weight weight of the robot [N]
  explicit ContactConfidence(double weight) : weight_(weight) {}

  /// Process one tick.
  void update(const Gains& gains, const ContactSignals& signals, double dt) noexcept;

  const Eigen::Vector4d& confidence() const noexcept { return confidence_; }
  /// True for each foot that is loaded according to the force sources alone, and for each foot
  /// whose force no source measures.
  const std::array<bool, kLegs>& loaded_by_forces() const noexcept { return loaded_by_forces_; }
  /// True for each foot whose contact is an assumption, because no source measures its force.
  const std::array<bool, kLegs>& assumed() const noexcept { return assumed_; }
  bool foot_force_est_works() const noexcept { return force_check_.foot_force_est_works(); }
  /// Write the verdicts and votes of all sources to a report.
  void write(EstimatorReport& report) const noexcept;

  void reset() noexcept { *this = ContactConfidence(weight_); }

 private:
  struct Foot {
    std::array<ContactEvidence, kContactSources> evidence{};
    StuckDetector est_stuck;
    FootForceCalibration calibration;
    // [s] Rises while footForceEst contradicts the torques, and falls otherwise.
    double contradiction_time = 0.0;
    // Contact state: becomes true at confidence 1 and false at confidence 0. It selects the
    // threshold of load_vote().
    bool loaded = true;
    double no_force_time =
        std::numeric_limits<double>::infinity();  // [s] time since the last force vote
  };
  ContactEvidence foot_force_est_evidence(const Gains& gains, const ContactSignals& signals,
                                          int leg, double dt) noexcept;
  void fuse_votes(const Gains& gains, const ContactSignals& signals, int leg, double dt) noexcept;

  double weight_;
  ForceSourceCheck force_check_;
  std::array<Foot, kLegs> feet_{};
  Eigen::Vector4d confidence_ = Eigen::Vector4d::Ones();
  std::array<bool, kLegs> loaded_by_forces_{true, true, true, true};
  std::array<bool, kLegs> assumed_{};
};

}  // namespace surefoot
