// SPDX-License-Identifier: BSD-3-Clause
#include "tick/delay_predictor.hpp"

#include <algorithm>

namespace surefoot {

namespace {
// Number of stored commands. Derived: more than the 50 commands in kMaxDelay at 1 kHz.
constexpr int kCapacity = 64;
// [periods] Delay that is assumed if ControllerOptions::delay is 0. Derived: a sample is one period
// old when it arrives, and the command computed from it acts one period later.
constexpr double kDefaultDelayPeriods = 2.0;
constexpr double kTimeTolerance = 1e-6;  // [s] numerical: rounding of summed periods
}  // namespace

DelayPredictor::DelayPredictor(int nv, double delay)
    : delay_(delay),
      sent_(kCapacity, SentCommand{Eigen::VectorXd::Zero(nv)}),
      dv_(Eigen::VectorXd::Zero(nv)),
      dq_(Eigen::VectorXd::Zero(nv)),
      predicted_(nv + 1, nv) {}

void DelayPredictor::advance(double dt) noexcept {
  if (count_ > 0) sent_[(next_ - 1 + kCapacity) % kCapacity].dt += dt;
}

void DelayPredictor::record(const Eigen::VectorXd& accelerations, const Vector12& tau,
                            const Vector3& f_push) noexcept {
  sent_[next_].accelerations = accelerations;
  sent_[next_].tau = tau;
  sent_[next_].f_push = f_push;
  sent_[next_].dt = 0.0;
  next_ = (next_ + 1) % kCapacity;
  count_ = std::min(count_ + 1, kCapacity);
}

double DelayPredictor::horizon(double period) const noexcept {
  return delay_ > 0.0 ? delay_ : kDefaultDelayPeriods * period;
}

const SentCommand* DelayPredictor::acting_command(double period) const noexcept {
  const double delay = horizon(period);
  double age = 0.0;
  for (int k = 1; k <= count_; ++k) {
    const SentCommand& sent = sent_[(next_ - k + kCapacity) % kCapacity];
    age += sent.dt;
    if (age > delay + kTimeTolerance) return &sent;
  }
  return nullptr;
}

RobotState& DelayPredictor::predict(const RobotState& state, double period) noexcept {
  const double delay = horizon(period);
  dv_.setZero();
  dq_ = delay * state.v;
  // Go backwards from the newest command. Each command acts until the next command begins to act.
  // `end` is the time after `state` [s] at which command k stops acting.
  double end = delay;
  for (int k = 1; k <= count_ && end > 0.0; ++k) {
    const SentCommand& sent = sent_[(next_ - k + kCapacity) % kCapacity];
    const double duration = std::min(sent.dt, end);
    dv_ += duration * sent.accelerations;
    dq_ += duration * (delay - end + 0.5 * duration) * sent.accelerations;
    end -= duration;
  }
  // The base part of dq_ is in base axes, like the base part of v.
  const Quaternion R(state.q[6], state.q[3], state.q[4], state.q[5]);
  const Quaternion turned = (R * exp_so3(dq_.segment<3>(3))).normalized();
  predicted_ = state;  // of equal sizes, so nothing is allocated
  predicted_.q.head<3>() += R * Vector3(dq_.head<3>());
  predicted_.q.segment<4>(3) = turned.coeffs();
  predicted_.q.tail(dq_.size() - 6) += dq_.tail(dq_.size() - 6);
  predicted_.v += dv_;
  return predicted_;
}

}  // namespace surefoot
