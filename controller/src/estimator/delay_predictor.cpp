// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/delay_predictor.hpp"

#include <algorithm>

namespace surefoot {

namespace {
constexpr int kRing = 64;          // commands that may be on their way: 50 ms at 1 kHz, and some
constexpr double kUntold = 2.0;    // periods on the way where no delay was told of
constexpr double kInstant = 1e-6;  // [s] periods are whole milliseconds
}  // namespace

DelayPredictor::DelayPredictor(int nv, double delay)
    : delay_(delay),
      sent_(kRing, SentCommand{Eigen::VectorXd::Zero(nv)}),
      dv_(Eigen::VectorXd::Zero(nv)),
      dq_(Eigen::VectorXd::Zero(nv)),
      predicted_(nv + 1, nv) {}

void DelayPredictor::elapse(double dt) noexcept {
  if (count_ > 0) sent_[(next_ - 1 + kRing) % kRing].dt += dt;
}

void DelayPredictor::remember(const Eigen::VectorXd& accelerations, double share,
                              const Vector12& tau, const Vector3& f_push) noexcept {
  sent_[next_].accelerations = share * accelerations;
  sent_[next_].tau = tau;
  sent_[next_].f_push = share * f_push;
  sent_[next_].dt = 0.0;
  next_ = (next_ + 1) % kRing;
  count_ = std::min(count_ + 1, kRing);
}

const SentCommand* DelayPredictor::acting(double period) const noexcept {
  const double on_the_way = active() ? delay_ : kUntold * period;
  double age = 0.0;
  for (int k = 1; k <= count_; ++k) {
    const SentCommand& sent = sent_[(next_ - k + kRing) % kRing];
    age += sent.dt;
    if (age > on_the_way + kInstant) return &sent;
  }
  return nullptr;
}

RobotState& DelayPredictor::predict(const RobotState& state) noexcept {
  dv_.setZero();
  dq_ = delay_ * state.v;
  // Backwards from the command that stops acting when the next one starts.
  double end = delay_;
  for (int k = 1; k <= count_ && end > 0.0; ++k) {
    const SentCommand& sent = sent_[(next_ - k + kRing) % kRing];
    const double lasts = std::min(sent.dt, end);
    dv_ += lasts * sent.accelerations;
    dq_ += lasts * (delay_ - end + 0.5 * lasts) * sent.accelerations;
    end -= lasts;
  }
  // dq is in base axes for the base, as v is.
  const Quaternion R(state.q[6], state.q[3], state.q[4], state.q[5]);
  const Quaternion turned = (R * exp_so3(dq_.segment<3>(3))).normalized();
  predicted_.q = state.q;
  predicted_.q.head<3>() += R * Vector3(dq_.head<3>());
  predicted_.q.segment<4>(3) = turned.coeffs();
  predicted_.q.tail(dq_.size() - 6) += dq_.tail(dq_.size() - 6);
  predicted_.v = state.v + dv_;
  predicted_.contact = state.contact;
  predicted_.f_outside = state.f_outside;
  predicted_.f_lasting = state.f_lasting;
  predicted_.moment_outside = state.moment_outside;
  predicted_.friction = state.friction;
  return predicted_;
}

}  // namespace surefoot
