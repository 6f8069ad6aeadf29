// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/contact_belief.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

constexpr double kJudgement = 0.1;       // [s] before a field is believed, or no longer
constexpr double kDenying = 0.25;        // share of the weight below which a field denies the load
constexpr double kCarrying = 0.5;        // share of the weight that shows the robot is carried
constexpr double kBalanced = 0.25;       // share by which torques may miss what is felt
constexpr double kContradiction = 0.15;  // share of the weight between two views of one load
constexpr double kPatience = 0.3;        // [s] of contradiction before a foot's sensor is left out
constexpr double kMoving = 0.3;          // [m/s] no foot that bears load moves like this for long
constexpr double kResting = 0.1;         // [m/s]
constexpr double kRisen = 0.006;         // [m] soft ground gives way by that much
constexpr double kSlideSays = 0.33;      // a foot may slide under load for a while
constexpr double kMotionWeight = 2.0;  // a foot that rises bears no ground, whatever else it bears
constexpr double kBalancedWeight = 1.12;
constexpr double kSeconds = 0.5;     // of motion that seconds a sensor
constexpr double kUndecided = 0.04;  // least agreement that moves the belief
constexpr double kMajority = 3.0;    // two of three move it at full speed

constexpr int kEst = static_cast<int>(ContactSource::kFootForceEst);
constexpr int kCount = static_cast<int>(ContactSource::kFootForce);
constexpr int kTau = static_cast<int>(ContactSource::kTauEst);
constexpr int kNoSlip = static_cast<int>(ContactSource::kNoSlip);

// Rest says nothing: feet rest in the air, too.
Evidence see_motion(double speed, double rise) noexcept {
  const double risen = std::clamp(rise / kRisen - 1.0, 0.0, 1.0);
  return {-std::max(speed > kMoving ? kSlideSays : 0.0, risen), Verdict::kGood};
}

// A live sensor is never quite still. One that has stopped where no load is, while the torques say
// load, has failed: both fields of a foot fail together, and would outvote them.
bool froze(const Evidence& sensor, bool still, const Evidence& tau) noexcept {
  return still && sensor.says < 0.0 && tau.verdict == Verdict::kGood && tau.says > 0.0;
}

}  // namespace

void ContactBelief::update(const Gains& gains, const ContactSignals& signals, double dt) noexcept {
  judge_est_field(signals, dt);
  const bool torques = signals.tau_est == Verdict::kGood;
  for (int leg = 0; leg < kLegs; ++leg) {
    Foot& foot = feet_[leg];
    const double load = torques ? signals.torque_load[leg] : NAN;
    Evidence& tau = foot.evidence[kTau];
    Evidence& est = foot.evidence[kEst];
    Evidence& count = foot.evidence[kCount];
    tau = {torques ? say_load(gains, load, 0.0, foot.loaded) : 0.0, signals.tau_est};
    foot.evidence[kNoSlip] = see_motion(signals.speed[leg], signals.rise[leg]);
    est = see_est(gains, signals, leg, dt);
    const bool est_froze = froze(est, foot.est.still(), tau);
    // Newtons of the same foot tell better what its counts mean than the leg's torques do.
    const bool newtons = est.verdict == Verdict::kGood && !est_froze;
    const double known = newtons ? signals.foot_force_est[leg] / weight_ : load;
    count = foot.count.update(gains, signals.foot_force[leg], known, foot.loaded, dt);
    if (froze(count, foot.count.still(), tau)) count.says = 0.0;
    if (est_froze) est.says = 0.0;
    vote(gains, signals, leg, dt);
  }
}

// The field as a whole: newtons that carry the robot, or a field that says nothing. Without torques
// the weight itself is the witness. In the air both are silent, and nothing is learnt.
void ContactBelief::judge_est_field(const ContactSignals& signals, double dt) noexcept {
  const auto& f = signals.foot_force_est;
  const double sum = (static_cast<double>(f[0]) + f[1] + f[2] + f[3]) / weight_;
  const bool torques = signals.tau_est == Verdict::kGood;
  const bool carried = torques ? signals.torque_load.sum() > kCarrying : sum < 2.0;
  const bool contradicts =
      est_alive_ ? torques && carried && sum < kDenying : carried && sum > kCarrying;
  est_doubt_ = contradicts ? est_doubt_ + dt : 0.0;
  if (est_doubt_ > kJudgement) {
    est_alive_ = !est_alive_;
    est_doubt_ = 0.0;
  }
}

Evidence ContactBelief::see_est(const Gains& gains, const ContactSignals& signals, int leg,
                                double dt) noexcept {
  Foot& foot = feet_[leg];
  const bool torques = signals.tau_est == Verdict::kGood;
  const double tau_load = torques ? signals.torque_load[leg] : NAN;
  const double load = signals.foot_force_est[leg] / weight_;
  Verdict verdict = foot.est.see(signals.foot_force_est[leg], tau_load, dt);
  // A hand under a foot bears what the ground does not: torques alone do not refute the newtons of
  // a foot that has risen.
  const bool contradicts =
      std::abs(load - tau_load) > std::max(kContradiction, 0.5 * std::abs(tau_load)) &&
      foot.evidence[kNoSlip].says > -kSeconds;
  const double step = contradicts ? dt : -dt;
  foot.contradicted = std::clamp(foot.contradicted + step, 0.0, 2.0 * kPatience);
  if (!est_alive_) {
    const bool zero = verdict == Verdict::kZero;
    return {0.0, zero ? verdict : Verdict::kUnjudged};
  }
  if (verdict == Verdict::kGood && foot.contradicted > kPatience) verdict = Verdict::kDisagrees;
  if (verdict != Verdict::kGood) return {0.0, verdict};
  return {say_load(gains, load, 0.0, foot.loaded), verdict};
}

// Do the torques carry what the accelerometer feels?
bool ContactBelief::balanced(const ContactSignals& signals) const noexcept {
  const double felt = std::max(signals.felt, 0.0);
  return std::abs(signals.torque_load.sum() - felt) < kBalanced * std::max(felt, 0.5);
}

void ContactBelief::vote(const Gains& gains, const ContactSignals& signals, int leg,
                         double dt) noexcept {
  Foot& foot = feet_[leg];
  const double weight_tau = balanced(signals) ? kBalancedWeight : 1.0;
  const double weights[kContactSources] = {1.0, 1.0, weight_tau, kMotionWeight};
  double sum = 0.0, voters = 0.0, forces = 0.0;
  for (int k = 0; k < kContactSources; ++k) {
    const Evidence& one = foot.evidence[k];
    if (one.verdict != Verdict::kGood || one.says == 0.0) continue;
    foot.told = foot.told || k != kNoSlip;
    sum += weights[k] * one.says;
    if (k != kNoSlip) forces += weights[k] * one.says;
    voters += weights[k];
  }
  bears_[leg] = !foot.told || forces > 0.0;
  double drive = 0.0;
  if (voters > 0.0) {
    const double agreement = sum / voters;
    if (std::abs(agreement) > kUndecided) drive = std::clamp(kMajority * agreement, -1.0, 1.0);
  } else if (!foot.told && signals.speed[leg] < kResting) {
    drive = 0.5;  // no forces in these reports: nothing but a foot that rests
  }
  const double step = gains.contact_dwell > dt ? dt / gains.contact_dwell : 1.0;
  probability_[leg] = std::clamp(probability_[leg] + drive * step, 0.0, 1.0);
  if (probability_[leg] >= 1.0) foot.loaded = true;
  if (probability_[leg] <= 0.0) foot.loaded = false;
}

void ContactBelief::write(EstimatorReport& report) const noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    for (int k = 0; k < kContactSources; ++k) {
      const Evidence& one = feet_[leg].evidence[k];
      report.contact_sources[k][leg] = one.verdict;
      report.contact_by_source(k, leg) = 0.5 + 0.5 * one.says;
    }
  }
}

}  // namespace surefoot
