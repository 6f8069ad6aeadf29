// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/step_detector.hpp"

namespace surefoot {

namespace {
// Contact confidence at which a foot touches down. Derived: half-way between off the ground and
// loaded.
constexpr double kInContact = 0.5;
// [s] Two touchdowns within this time are steps. Chosen: longer than a stride of slow gaits of four
// feet, 0.5 s from foot to foot, and shorter than the time between two accidents.
constexpr double kMemory = 1.0;
// [s] A foot swings after it has been off the ground for this time. Chosen: longer than noise in
// the contacts and than a bounce after touchdown, half of the shortest swing of a trot.
constexpr double kMinSwing = 0.05;
// [s] Touchdowns that follow sooner belong to one impact, for example both feet of a trot. Chosen:
// half of the shortest stance of a trot.
constexpr double kImpactTime = 0.08;
// [s] Time for which all feet stand before the robot rests. Chosen: impacts vibrate for 50 ms.
constexpr double kSettlingTime = 0.3;
// [s] Time after the last step for which soles still sink. Chosen: longer than the last ramp of the
// loads, and shorter than the time until a standing robot is pushed.
constexpr double kAfterSteps = 0.3;
}  // namespace

void StepDetector::update(const Eigen::Vector4d& contact, double dt) noexcept {
  last_ += dt;
  second_last_ += dt;
  rest_time_ += dt;
  for (int leg = 0; leg < kLegs; ++leg) {
    const bool in_contact = contact[leg] > kInContact;
    const bool swings = air_time_[leg] > kMinSwing;
    air_time_[leg] = in_contact ? 0.0 : air_time_[leg] + dt;
    if (swings) rest_time_ = 0.0;
    if (!swings || !in_contact || last_ < kImpactTime) continue;
    second_last_ = last_;
    last_ = 0.0;
  }
  time_since_steps_ = steps() ? 0.0 : time_since_steps_ + dt;
}

bool StepDetector::steps() const noexcept { return planned_ || second_last_ < kMemory; }

bool StepDetector::stepped_lately() const noexcept {
  return steps() || time_since_steps_ < kAfterSteps;
}

bool StepDetector::rests() const noexcept { return !planned_ && rest_time_ > kSettlingTime; }

}  // namespace surefoot
