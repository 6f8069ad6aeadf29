// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/friction_estimate.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/standing_pose.hpp"

namespace surefoot {

namespace {

// All values are chosen. Test: test_friction_estimate.cpp, test_learnt_friction.py.
// [h] Sliding distance under the weight of the robot that counts as much as RobotConfig::friction:
// 0.5 mm at h = 0.3 m. If smaller: a single wrong velocity sets the estimate. If larger: a foot
// slides further before the controller knows the ground.
constexpr double kPriorDistance = 0.0017;
// [h] The same distance for sliding that contradicts the ratio that held.
constexpr double kContradictionDistance = 0.0033;
// [h] Distance travelled over which all memory fades to 1/e: 3 m at h = 0.3 m. If smaller: the
// robot slips again every few steps. If larger: it stays careful for long after it has left the
// ice.
constexpr double kMemoryDistance = 10.0;
// [sqrt(g h)] Speed above which a loaded foot slides: 5 cm/s at h = 0.3 m, larger than the noise of
// the velocity at rest. While feet step, 12 cm/s, because soft soles move after touchdown.
constexpr double kSlidingSpeed = 0.03;
constexpr double kSteppingSlidingSpeed = 0.07;
// [sqrt(g h)] Speed below which a foot holds.
constexpr double kHoldingSpeed = 0.012;
// [m g] Load above which a foot counts, larger than the force error of joint friction; a foot that
// steps lands with more than that.
constexpr double kMinLoad = 0.1;
constexpr double kSteppingMinLoad = 0.2;
// Cosine of the angle between the friction force and the direction against the sliding, above which
// the force is a friction force. Coulomb's law has 1; noise and changes of the direction lower it.
constexpr double kMinAlignment = 0.8;
// Share of the ratio that held, below which sliding contradicts it. Larger than the error of the
// ratios.
constexpr double kContradiction = 0.8;
// Share of a learnt coefficient that no foot uses. Larger than the errors of the torques and of the
// assumed coefficient's part in the estimate. If smaller: feet go on sliding after the coefficient
// has been learnt.
constexpr double kMargin = 0.1;
// Share of the learnt coefficient from which a foot nears the limit; larger than the error of the
// ratios.
constexpr double kNearLimit = 0.8;
// Confidence from which the limit counts as known. Chosen; it excludes memories that have faded.
constexpr double kMinConfidence = 0.01;
// [sqrt(h/g)] Time after touchdown from which a foot counts: 40 ms at h = 0.3 m. Before, it
// bounces, and the direction of its force changes faster than LegForces can follow.
constexpr double kSettlingTime = 0.23;
// [s] Time constants of the low-passes: of the velocities, equal to LegForces::kFilterTime, so that
// velocity and force belong together; and of the ratio that holds, longer than an impact.
constexpr double kVelocityFilterTime = LegForces::kFilterTime;
constexpr double kRatioFilterTime = 0.02;
// Contact confidence above which a foot is on the ground.
constexpr double kContact = 0.5;
// Smallest coefficient. With less, the QP could not balance the robot at all.
constexpr double kMinCoefficient = 0.1;

}  // namespace

FrictionEstimate::FrictionEstimate(const Robot& robot)
    : assumed_(robot.config().friction),
      weight_(robot.mass() * kGravity),
      height_(standing_com_height(robot)),
      coefficient_(assumed_) {}

void FrictionEstimate::update(const FrictionInput& input, double dt) noexcept {
  const double fading = std::exp(-input.travelled / (kMemoryDistance * height_));
  friction_work_ *= fading;
  sliding_ *= fading;
  held_ *= fading;
  filter_velocities(input, dt);
  const double common_speed = common_error(input.v_error);
  for (int leg = 0; leg < kLegs; ++leg) learn_from_foot(leg, input, common_speed, dt);
  const double estimate =
      assumed_ + (friction_work_ - assumed_ * sliding_) / (sliding_ + kPriorDistance);
  coefficient_ =
      std::clamp(std::max(estimate, held_), std::min(kMinCoefficient, assumed_), assumed_);
}

void FrictionEstimate::filter_velocities(const FrictionInput& input, double dt) noexcept {
  const FeetMatrix v =
      input.v_contact - input.normal * (input.normal.transpose() * input.v_contact);
  for (int leg = 0; leg < kLegs; ++leg) {
    const bool in_contact = input.contact[leg] > kContact;
    // The low-pass restarts at touchdown, because the velocity of the swing is no sliding.
    if (in_contact && stance_time_[leg] == 0.0) v_filtered_.col(leg) = v.col(leg);
    stance_time_[leg] = in_contact ? stance_time_[leg] + dt : 0.0;
    v_filtered_.col(leg) += dt / (dt + kVelocityFilterTime) * (v.col(leg) - v_filtered_.col(leg));
  }
}

// Return the speed of the slowest foot on the ground [m/s], at most v_error, or 0 with fewer than
// two feet on the ground: a speed that all feet have in common may be an error of the base
// velocity. A foot with little load counts too: otherwise two feet that carry the weight and slide
// together teach nothing.
double FrictionEstimate::common_error(double v_error) const noexcept {
  double slowest = v_error;
  int count = 0;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (stance_time_[leg] == 0.0) continue;
    slowest = std::min(slowest, v_filtered_.col(leg).norm());
    ++count;
  }
  return count >= 2 ? slowest : 0.0;
}

void FrictionEstimate::learn_from_foot(int leg, const FrictionInput& input, double common_speed,
                                       double dt) noexcept {
  const Vector3 force = input.forces.col(leg), v = v_filtered_.col(leg);
  const double f_n = force.dot(input.normal);
  if (stance_time_[leg] <= kSettlingTime * std::sqrt(height_ / kGravity) ||
      f_n <= (input.stepping ? kSteppingMinLoad : kMinLoad) * weight_) {
    holding_ratio_[leg] = at_limit_[leg] = 0.0;
    slides_[leg] = false;
    return;
  }
  const Vector3 f_t = force - f_n * input.normal;
  const double ratio = f_t.norm() / f_n, speed = v.norm(), unit = std::sqrt(kGravity * height_);
  holding_ratio_[leg] += dt / (dt + kRatioFilterTime) * (ratio - holding_ratio_[leg]);
  if (speed < kHoldingSpeed * unit) held_ = std::max(held_, holding_ratio_[leg]);
  const double opposed_speed = -v.dot(f_t) / std::max(f_t.norm(), 1e-9);
  const bool opposed = opposed_speed > kMinAlignment * speed;
  // While feet step, an unknown friction of the joints makes these forces too large.
  slides_[leg] = !input.stepping && opposed && ratio > kMinCoefficient;
  at_limit_[leg] = input.stepping ? 0.0 : limit_share(ratio);
  const double sliding_speed = opposed_speed - common_speed;
  const double least_speed = (input.stepping ? kSteppingSlidingSpeed : kSlidingSpeed) * unit;
  if (opposed && sliding_speed > least_speed)
    slide(ratio, f_n / weight_ * sliding_speed * dt / height_);
}

// Return how near a ratio is to the limit, 0 .. 1: the ratio of the feet that slid, without the
// part of RobotConfig::friction in the estimate.
double FrictionEstimate::limit_share(double ratio) const noexcept {
  if (confidence() < kMinConfidence) return 0.0;
  const double nearness = ratio * sliding_ / std::max(friction_work_, 1e-9) - kNearLimit;
  return confidence() * std::clamp(nearness / (1.0 - kNearLimit), 0.0, 1.0);
}

// Return the part of the estimate that sliding feet have given, 0 .. 1.
double FrictionEstimate::confidence() const noexcept {
  return sliding_ / (sliding_ + kPriorDistance);
}

double FrictionEstimate::usable_share() const noexcept {
  return (1.0 - kMargin * confidence()) * coefficient_ / assumed_;
}

void FrictionEstimate::slide(double ratio, double weighted_distance) noexcept {
  if (ratio < held_) {
    held_ += weighted_distance / (weighted_distance + kContradictionDistance) * (ratio - held_);
  }
  if (ratio < kContradiction * held_) return;
  friction_work_ += ratio * weighted_distance;
  sliding_ += weighted_distance;
}

void FrictionEstimate::reset() noexcept {
  friction_work_ = sliding_ = held_ = 0.0;
  coefficient_ = assumed_;
  v_filtered_.setZero();
  stance_time_.setZero();
  slides_.fill(false);
  at_limit_.setZero();
  holding_ratio_.setZero();
}

}  // namespace surefoot
