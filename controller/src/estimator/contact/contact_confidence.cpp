// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/contact_confidence.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

// Votes range from -1 (off the ground) to 1 (loaded). All values are chosen unless stated; see
// docs/explanation/estimator.md, Contact. Tests: test_contact.cpp, benchmarks/estimation.
//
// Two sources agree if their loads of a foot differ by less than this share of the weight. Larger
// than the noise and the model errors of the torques, smaller than 0.25, the load of one foot.
constexpr double kMaxLoadDifference = 0.15;
// [s] footForceEst is excluded after it has contradicted the torques for this time. Equal to
// kDetectionTime of ForceSourceCheck.
constexpr double kDetectionTime = 0.3;
// [s/s] Rate at which contradiction_time falls while there is no contradiction. During a
// contradiction it rises at rate 1.
constexpr double kRecoveryRate = 0.25;
// [s] Forces count as unavailable after no force source has voted for this time. Longer than pauses
// in the votes of up to kDetectionTime. If larger: a foot whose sensors are dead stays out of
// contact for longer.
constexpr double kNoForceTime = 0.5;
// [m/s] Speed above which the motion of a foot votes against contact. At least twice the gain
// slip_speed (0.15), and smaller than the speed of a swing foot.
constexpr double kMovingSpeed = 0.3;
// [m/s] Speed below which a foot is at rest. Smaller than the gain slip_speed (0.15).
constexpr double kRestSpeed = 0.1;
// [m] Clearance above which the motion of a foot votes against contact. The vote reaches -1 at
// twice this clearance. If smaller: a loaded foot that rises on soft ground votes against contact.
// If larger: a lift is detected late.
constexpr double kClearanceThreshold = 0.006;
// Magnitude of the vote against contact that a speed above kMovingSpeed gives. Chosen small,
// because a loaded foot may slide.
constexpr double kSlideVote = 0.33;
// Weight of the source foot motion. A rising foot is off the ground, whatever force its sensors
// show. So the weight is larger than that of one other source (1), but not larger than that of two.
constexpr double kMotionWeight = 2.0;
// Weight of torques that match the accelerometer. Above 1: if torques and one other source
// contradict each other, the mean vote is 0.06 in favour of the torques instead of 0, and the
// confidence changes slowly.
constexpr double kBalancedWeight = 1.12;
constexpr double kConfirmingVote = 0.5;  // magnitude above which a vote confirms footForceEst
// Magnitude of the mean vote above which the confidence changes. Below 0.06, the mean vote of two
// contradicting sources (see kBalancedWeight).
constexpr double kMinAgreement = 0.04;
// Rate of change of the confidence, in units of 1 / contact_dwell, divided by the mean vote.
// Derived: if two of three sources vote 1 and the third votes -1, the mean vote is 1/3 and the rate
// shall be 1.
constexpr double kAgreementGain = 3.0;

// Share of the gain contact_dwell while the robot steps. Chosen: contacts of steps are then known
// within 10 ms. A robot that stands has time to outvote wrong samples of several sensors.
constexpr double kSteppingDwell = 0.4;

constexpr int kFootForceEstIndex = static_cast<int>(ContactSource::kFootForceEst);
constexpr int kFootForceIndex = static_cast<int>(ContactSource::kFootForce);
constexpr int kTauEstIndex = static_cast<int>(ContactSource::kTauEst);
constexpr int kFootMotion = static_cast<int>(ContactSource::kFootMotion);

// Return the evidence from the motion of a foot, which can only vote against contact. A foot at
// rest is no evidence of contact, because a foot can be at rest in the air.
ContactEvidence motion_evidence(double speed, double clearance) noexcept {
  const double risen = std::clamp(clearance / kClearanceThreshold - 1.0, 0.0, 1.0);
  return {-std::max(speed > kMovingSpeed ? kSlideVote : 0.0, risen), SensorVerdict::kGood};
}

// Return whether footForceEst (`est`) and footForce (`count`) of a foot count as one source. They
// do if both are constant and show no load while the torques show load. The two votes then have one
// common cause: either both sensors have failed together, or the foot is in the air and its leg
// presses against something.
bool fields_fail_together(const ContactEvidence& est, bool est_unchanged,
                          const ContactEvidence& count, bool count_unchanged,
                          const ContactEvidence& tau) noexcept {
  return est_unchanged && count_unchanged && est.vote < 0.0 && count.vote < 0.0 &&
         tau.verdict == SensorVerdict::kGood && tau.vote > 0.0;
}

}  // namespace

void ContactConfidence::update(const Gains& gains, const ContactSignals& measured_signals,
                               double dt) noexcept {
  ContactSignals signals = measured_signals;
  const auto& f = signals.foot_force_est;
  force_check_.update(
      {(static_cast<double>(f[0]) + f[1] + f[2] + f[3]) / weight_, signals.torque_load.sum(),
       signals.load_factor, signals.tau_est == SensorVerdict::kGood},
      dt);
  if (force_check_.torques_disagree() && signals.tau_est == SensorVerdict::kGood) {
    signals.tau_est = SensorVerdict::kDisagrees;
  }
  const bool torques_are_good = signals.tau_est == SensorVerdict::kGood;
  for (int leg = 0; leg < kLegs; ++leg) {
    Foot& foot = feet_[leg];
    const double load = torques_are_good ? signals.torque_load[leg] : NAN;
    foot.evidence[kTauEstIndex] = {
        torques_are_good ? load_vote(gains, load, 0.0, foot.loaded) : 0.0, signals.tau_est};
    foot.evidence[kFootMotion] = motion_evidence(signals.speed[leg], signals.clearance[leg]);
    const ContactEvidence& est = foot.evidence[kFootForceEstIndex] =
        foot_force_est_evidence(gains, signals, leg, dt);
    // The torques calibrate footForce. Without torques, footForceEst calibrates it. The calibration
    // pauses while torques and footForceEst contradict each other.
    const bool est_is_good = est.verdict == SensorVerdict::kGood;
    const double est_load = signals.foot_force_est[leg] / weight_;
    const double known_load = est_is_good && !torques_are_good ? est_load : load;
    const bool load_reliable =
        !est_is_good || !torques_are_good || std::abs(est_load - load) < kMaxLoadDifference;
    foot.evidence[kFootForceIndex] = foot.calibration.update(
        gains, signals.foot_force[leg], known_load, load_reliable, foot.loaded, dt);
    fuse_votes(gains, signals, leg, dt);
  }
}

ContactEvidence ContactConfidence::foot_force_est_evidence(const Gains& gains,
                                                           const ContactSignals& signals, int leg,
                                                           double dt) noexcept {
  Foot& foot = feet_[leg];
  const bool torques_are_good = signals.tau_est == SensorVerdict::kGood;
  const double tau_load = torques_are_good ? signals.torque_load[leg] : NAN;
  const double load = signals.foot_force_est[leg] / weight_;
  SensorVerdict verdict = foot.est_stuck.update(signals.foot_force_est[leg], tau_load, dt);
  // A person who lifts a foot loads the leg as the ground does. So a contradiction by the torques
  // does not count if footForce or the motion of the foot confirms footForceEst.
  // `loads_differ`: the limit for large loads is half of the load (chosen), because torques have
  // scale errors. `signs_differ`: footForceEst shows a clear load (twice the threshold), but the
  // torques show a force that pulls the foot towards the ground (a negative load).
  const bool loads_differ =
      std::abs(load - tau_load) > std::max(kMaxLoadDifference, 0.5 * std::abs(tau_load));
  const bool signs_differ = load > 2.0 * gains.contact_force_on && tau_load < 0.0;
  const bool confirmed = foot.evidence[kFootMotion].vote < -kConfirmingVote ||
                         foot.evidence[kFootForceIndex].vote * (load - tau_load) >
                             kConfirmingVote * kMaxLoadDifference;
  const bool contradicts = (loads_differ || signs_differ) && !confirmed;
  const double step = contradicts ? dt : -kRecoveryRate * dt;
  foot.contradiction_time = std::clamp(foot.contradiction_time + step, 0.0, 2.0 * kDetectionTime);
  if (!force_check_.foot_force_est_works()) {
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
      foot.evidence[kFootForceEstIndex], foot.est_stuck.is_unchanged(),
      foot.evidence[kFootForceIndex], foot.calibration.is_unchanged(), foot.evidence[kTauEstIndex]);
  const double weights[kContactSources] = {fail_together ? 0.5 : 1.0, fail_together ? 0.5 : 1.0,
                                           weight_tau, kMotionWeight};
  double vote_sum = 0.0, weight_sum = 0.0, force_sum = 0.0, force_weight = 0.0;
  for (int k = 0; k < kContactSources; ++k) {
    const ContactEvidence& source = foot.evidence[k];
    if (source.verdict != SensorVerdict::kGood || source.vote == 0.0) continue;
    vote_sum += weights[k] * source.vote;
    weight_sum += weights[k];
    if (k == kFootMotion) continue;
    force_sum += weights[k] * source.vote;
    force_weight += weights[k];
  }
  foot.no_force_time = force_weight > 0.0 ? 0.0 : foot.no_force_time + dt;
  const bool force_available = foot.no_force_time < kNoForceTime;
  assumed_[leg] = !force_available;
  loaded_by_forces_[leg] = force_available ? force_sum > 0.0 : !signals.standing_refuted;
  double rate = 0.0;
  if (assumed_[leg] && signals.standing_refuted) {
    rate = -1.0;
  } else if (weight_sum > 0.0) {
    const double agreement = vote_sum / weight_sum;
    if (std::abs(agreement) > kMinAgreement)
      rate = std::clamp(kAgreementGain * agreement, -1.0, 1.0);
  } else if (!force_available && signals.speed[leg] < kRestSpeed) {
    rate = 0.5;  // the foot is at rest and no source votes: assume contact, at half the usual rate
  }
  const double dwell = (signals.steps ? kSteppingDwell : 1.0) * gains.contact_dwell;
  const double step = dwell > dt ? dt / dwell : 1.0;
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
