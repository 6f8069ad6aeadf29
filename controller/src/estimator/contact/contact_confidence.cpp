// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/contact_confidence.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

constexpr double kMaxLoadDifference = 0.15;  // share of the weight between two views of one load
constexpr double kDetectionTime = 0.3;  // [s] of contradiction before a foot's sensor is left out
constexpr double kRecoveryRate = 0.25;  // how much slower it comes back than it goes
constexpr double kSilenceTime = 0.5;    // [s] after which nobody speaks
constexpr double kMovingSpeed = 0.3;    // [m/s] no foot that bears load moves like this for long
constexpr double kRestSpeed = 0.1;      // [m/s]
constexpr double kClearanceThreshold = 0.006;  // [m] soft ground gives way by that much
constexpr double kSlideVote = 0.33;            // a foot may slide under load for a while
constexpr double kMotionWeight = 2.0;  // a foot that rises bears no ground, whatever else it bears
constexpr double kBalancedWeight = 1.12;
constexpr double kConfirmingVote = 0.5;  // of motion that seconds a sensor
constexpr double kMinAgreement = 0.04;   // least agreement that moves the belief
constexpr double kAgreementGain = 3.0;   // two of three move it at full speed

constexpr int kEst = static_cast<int>(ContactSource::kFootForceEst);
constexpr int kCount = static_cast<int>(ContactSource::kFootForce);
constexpr int kTau = static_cast<int>(ContactSource::kTauEst);
constexpr int kNoSlip = static_cast<int>(ContactSource::kNoSlip);

// Rest says nothing: feet rest in the air, too.
ContactEvidence motion_evidence(double speed, double clearance) noexcept {
  const double risen = std::clamp(clearance / kClearanceThreshold - 1.0, 0.0, 1.0);
  return {-std::max(speed > kMovingSpeed ? kSlideVote : 0.0, risen), SensorVerdict::kGood};
}

// A foot's two fields fail together. Where both read no load, have stopped, and the torques say
// load, that is one failure (or a foot in the air that presses on something): not two witnesses.
bool fields_fail_together(const ContactEvidence& est, bool est_unchanged,
                          const ContactEvidence& count, bool count_unchanged,
                          const ContactEvidence& tau) noexcept {
  return est_unchanged && count_unchanged && est.vote < 0.0 && count.vote < 0.0 &&
         tau.verdict == SensorVerdict::kGood && tau.vote > 0.0;
}

}  // namespace

void ContactConfidence::update(const Gains& gains, const ContactSignals& all, double dt) noexcept {
  ContactSignals signals = all;
  const auto& f = signals.foot_force_est;
  force_check_.update(
      {(static_cast<double>(f[0]) + f[1] + f[2] + f[3]) / weight_, signals.torque_load.sum(),
       signals.load_factor, signals.tau_est == SensorVerdict::kGood},
      dt);
  if (force_check_.torques_disagree() && signals.tau_est == SensorVerdict::kGood) {
    signals.tau_est = SensorVerdict::kDisagrees;
  }
  const bool torques = signals.tau_est == SensorVerdict::kGood;
  for (int leg = 0; leg < kLegs; ++leg) {
    Foot& foot = feet_[leg];
    const double load = torques ? signals.torque_load[leg] : NAN;
    foot.evidence[kTau] = {torques ? load_vote(gains, load, 0.0, foot.loaded) : 0.0,
                           signals.tau_est};
    foot.evidence[kNoSlip] = motion_evidence(signals.speed[leg], signals.clearance[leg]);
    const ContactEvidence& est = foot.evidence[kEst] =
        foot_force_est_evidence(gains, signals, leg, dt);
    // Torques tell what the foot's counts mean, its newtons without them; nobody while the two
    // contradict each other.
    const bool newtons = est.verdict == SensorVerdict::kGood;
    const double est_load = signals.foot_force_est[leg] / weight_;
    const double known_load = newtons && !torques ? est_load : load;
    const bool load_reliable =
        !newtons || !torques || std::abs(est_load - load) < kMaxLoadDifference;
    foot.evidence[kCount] = foot.calibration.update(gains, signals.foot_force[leg], known_load,
                                                    load_reliable, foot.loaded, dt);
    fuse_votes(gains, signals, leg, dt);
  }
}

ContactEvidence ContactConfidence::foot_force_est_evidence(const Gains& gains,
                                                           const ContactSignals& signals, int leg,
                                                           double dt) noexcept {
  Foot& foot = feet_[leg];
  const bool torques = signals.tau_est == SensorVerdict::kGood;
  const double tau_load = torques ? signals.torque_load[leg] : NAN;
  const double load = signals.foot_force_est[leg] / weight_;
  SensorVerdict verdict = foot.est_stuck.update(signals.foot_force_est[leg], tau_load, dt);
  // A hand under a foot bears what the ground does not: torques alone do not refute newtons that
  // the foot's counts or its rise second.
  const bool far =
      std::abs(load - tau_load) > std::max(kMaxLoadDifference, 0.5 * std::abs(tau_load));
  const bool opposite = load > 2.0 * gains.contact_force_on && tau_load < 0.0;
  const bool confirmed =
      foot.evidence[kNoSlip].vote < -kConfirmingVote ||
      foot.evidence[kCount].vote * (load - tau_load) > kConfirmingVote * kMaxLoadDifference;
  const bool contradicts = (far || opposite) && !confirmed;
  const double step = contradicts ? dt : -kRecoveryRate * dt;
  foot.contradiction_time = std::clamp(foot.contradiction_time + step, 0.0, 2.0 * kDetectionTime);
  if (!force_check_.foot_force_est_alive()) {
    const bool zero = verdict == SensorVerdict::kZero;
    return {0.0, zero ? verdict : SensorVerdict::kUnjudged};
  }
  if (verdict == SensorVerdict::kGood && foot.contradiction_time > kDetectionTime)
    verdict = SensorVerdict::kDisagrees;
  if (verdict != SensorVerdict::kGood) return {0.0, verdict};
  return {load_vote(gains, load, 0.0, foot.loaded), verdict};
}

void ContactConfidence::fuse_votes(const Gains& gains, const ContactSignals& signals, int leg,
                                   double dt) noexcept {
  Foot& foot = feet_[leg];
  const double weight_tau = force_check_.torques_balance() ? kBalancedWeight : 1.0;
  const bool fail_together = fields_fail_together(
      foot.evidence[kEst], foot.est_stuck.is_unchanged(), foot.evidence[kCount],
      foot.calibration.is_unchanged(), foot.evidence[kTau]);
  const double weights[kContactSources] = {fail_together ? 0.5 : 1.0, fail_together ? 0.5 : 1.0,
                                           weight_tau, kMotionWeight};
  double vote_sum = 0.0, weight_sum = 0.0, force_sum = 0.0, force_weight = 0.0;
  for (int k = 0; k < kContactSources; ++k) {
    const ContactEvidence& source = foot.evidence[k];
    if (source.verdict != SensorVerdict::kGood || source.vote == 0.0) continue;
    vote_sum += weights[k] * source.vote;
    weight_sum += weights[k];
    if (k == kNoSlip) continue;
    force_sum += weights[k] * source.vote;
    force_weight += weights[k];
  }
  foot.silent_time = force_weight > 0.0 ? 0.0 : foot.silent_time + dt;
  const bool force_available = foot.silent_time < kSilenceTime;
  loaded_by_forces_[leg] = !force_available || force_sum > 0.0;
  double rate = 0.0;
  if (weight_sum > 0.0) {
    const double agreement = vote_sum / weight_sum;
    if (std::abs(agreement) > kMinAgreement)
      rate = std::clamp(kAgreementGain * agreement, -1.0, 1.0);
  } else if (!force_available && signals.speed[leg] < kRestSpeed) {
    rate = 0.5;  // no force speaks: nothing but a foot that rests
  }
  const double step = gains.contact_dwell > dt ? dt / gains.contact_dwell : 1.0;
  confidence_[leg] = std::clamp(confidence_[leg] + rate * step, 0.0, 1.0);
  if (confidence_[leg] >= 1.0) foot.loaded = true;
  if (confidence_[leg] <= 0.0) foot.loaded = false;
}

void ContactConfidence::write(EstimatorReport& report) const noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    for (int k = 0; k < kContactSources; ++k) {
      const ContactEvidence& evidence = feet_[leg].evidence[k];
      report.contact_sources[k][leg] = evidence.verdict;
      report.contact_by_source(k, leg) = 0.5 + 0.5 * evidence.vote;
    }
  }
}

}  // namespace surefoot
