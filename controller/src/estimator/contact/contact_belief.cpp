// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/contact_belief.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

constexpr double kContradiction = 0.15;  // share of the weight between two views of one load
constexpr double kPatience = 0.3;        // [s] of contradiction before a foot's sensor is left out
constexpr double kForgiving = 0.25;      // how much slower it comes back than it goes
constexpr double kSilence = 0.5;         // [s] after which nobody speaks
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

// A foot's two fields fail together. Where both read no load, have stopped, and the torques say
// load, that is one failure (or a foot in the air that presses on something): not two witnesses.
bool one_witness(const Evidence& est, bool est_still, const Evidence& count, bool count_still,
                 const Evidence& tau) noexcept {
  return est_still && count_still && est.says < 0.0 && count.says < 0.0 &&
         tau.verdict == Verdict::kGood && tau.says > 0.0;
}

}  // namespace

void ContactBelief::update(const Gains& gains, const ContactSignals& all, double dt) noexcept {
  ContactSignals signals = all;
  const auto& f = signals.foot_force_est;
  judge_.update({(static_cast<double>(f[0]) + f[1] + f[2] + f[3]) / weight_,
                 signals.torque_load.sum(), signals.felt, signals.tau_est == Verdict::kGood},
                dt);
  if (judge_.torques_disagree() && signals.tau_est == Verdict::kGood) {
    signals.tau_est = Verdict::kDisagrees;
  }
  const bool torques = signals.tau_est == Verdict::kGood;
  for (int leg = 0; leg < kLegs; ++leg) {
    Foot& foot = feet_[leg];
    const double load = torques ? signals.torque_load[leg] : NAN;
    foot.evidence[kTau] = {torques ? say_load(gains, load, 0.0, foot.loaded) : 0.0,
                           signals.tau_est};
    foot.evidence[kNoSlip] = see_motion(signals.speed[leg], signals.rise[leg]);
    const Evidence& est = foot.evidence[kEst] = see_est(gains, signals, leg, dt);
    // Torques tell what the foot's counts mean, its newtons without them; nobody while the two
    // contradict each other.
    const bool newtons = est.verdict == Verdict::kGood;
    const double est_load = signals.foot_force_est[leg] / weight_;
    const double known = newtons && !torques ? est_load : load;
    const bool sure = !newtons || !torques || std::abs(est_load - load) < kContradiction;
    foot.evidence[kCount] =
        foot.count.update(gains, signals.foot_force[leg], known, sure, foot.loaded, dt);
    vote(gains, signals, leg, dt);
  }
}

Evidence ContactBelief::see_est(const Gains& gains, const ContactSignals& signals, int leg,
                                double dt) noexcept {
  Foot& foot = feet_[leg];
  const bool torques = signals.tau_est == Verdict::kGood;
  const double tau_load = torques ? signals.torque_load[leg] : NAN;
  const double load = signals.foot_force_est[leg] / weight_;
  Verdict verdict = foot.est.see(signals.foot_force_est[leg], tau_load, dt);
  // A hand under a foot bears what the ground does not: torques alone do not refute newtons that
  // the foot's counts or its rise second.
  const bool far = std::abs(load - tau_load) > std::max(kContradiction, 0.5 * std::abs(tau_load));
  const bool opposite = load > 2.0 * gains.contact_force_on && tau_load < 0.0;
  const bool seconded = foot.evidence[kNoSlip].says < -kSeconds ||
                        foot.evidence[kCount].says * (load - tau_load) > kSeconds * kContradiction;
  const bool contradicts = (far || opposite) && !seconded;
  const double step = contradicts ? dt : -kForgiving * dt;
  foot.contradicted = std::clamp(foot.contradicted + step, 0.0, 2.0 * kPatience);
  if (!judge_.est_alive()) {
    const bool zero = verdict == Verdict::kZero;
    return {0.0, zero ? verdict : Verdict::kUnjudged};
  }
  if (verdict == Verdict::kGood && foot.contradicted > kPatience) verdict = Verdict::kDisagrees;
  if (verdict != Verdict::kGood) return {0.0, verdict};
  return {say_load(gains, load, 0.0, foot.loaded), verdict};
}

void ContactBelief::vote(const Gains& gains, const ContactSignals& signals, int leg,
                         double dt) noexcept {
  Foot& foot = feet_[leg];
  const double weight_tau = judge_.torques_balance() ? kBalancedWeight : 1.0;
  const bool one = one_witness(foot.evidence[kEst], foot.est.still(), foot.evidence[kCount],
                               foot.count.still(), foot.evidence[kTau]);
  const double weights[kContactSources] = {one ? 0.5 : 1.0, one ? 0.5 : 1.0, weight_tau,
                                           kMotionWeight};
  double sum = 0.0, voters = 0.0, forces = 0.0, speaking = 0.0;
  for (int k = 0; k < kContactSources; ++k) {
    const Evidence& one_of = foot.evidence[k];
    if (one_of.verdict != Verdict::kGood || one_of.says == 0.0) continue;
    sum += weights[k] * one_of.says;
    voters += weights[k];
    if (k == kNoSlip) continue;
    forces += weights[k] * one_of.says;
    speaking += weights[k];
  }
  foot.silent = speaking > 0.0 ? 0.0 : foot.silent + dt;
  const bool told = foot.silent < kSilence;
  bears_[leg] = !told || forces > 0.0;
  double drive = 0.0;
  if (voters > 0.0) {
    const double agreement = sum / voters;
    if (std::abs(agreement) > kUndecided) drive = std::clamp(kMajority * agreement, -1.0, 1.0);
  } else if (!told && signals.speed[leg] < kResting) {
    drive = 0.5;  // no force speaks: nothing but a foot that rests
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
