// SPDX-License-Identifier: BSD-3-Clause
#include "gait/stepping.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "gait/sway_input.hpp"
#include "reference/capture_margin.hpp"

namespace surefoot {

namespace {

// [sqrt(g h)] Velocity error below which a robot is not recovering from a push. Chosen: twice the
// velocity RMSE of a walk at 1.5 m/s.
constexpr double kSteadySpeed = 0.12;
// can_stand() [h]: largest distance of a foot from its place in the nominal stance, and of the
// centre of mass and the capture point from the middle of that stance; 1 cm and 3 cm at h = 0.3 m.
// Chosen: with 0.045 a b1, h = 0.5 m, ended a walk with a foot 2 cm off. From 3 cm, a quarter of
// the way to the feet beside the body, the stand needs no recovery step.
constexpr double kStopDistance = 0.035;
constexpr double kStopCapture = 0.1;

HorizontalMotion measured_motion(const PlannerInput& input) noexcept {
  const Matrix3& R = input.R_world_base;
  return {input.p_com.head<2>(), input.v_com.head<2>(), std::atan2(R(1, 0), R(0, 0))};
}

// Return a leg of the pair that shall step first: the capture point is then nearest to the line
// between the feet of the other pair.
int leg_to_swing(const PlannerInput& input) noexcept {
  const Eigen::Vector2d capture = capture_point(input.dynamics);
  const auto distance = [&](int a, int b) {
    const Eigen::Vector2d p = input.p_feet.col(a).head<2>();
    const Eigen::Vector2d line = (input.p_feet.col(b).head<2>() - p).normalized();
    const Eigen::Vector2d d = capture - p;
    return std::abs(line.x() * d.y() - line.y() * d.x());
  };
  return distance(FL_, RR_) < distance(FR_, RL_) ? FR_ : FL_;
}

// Return the points of the ground under the feet, without the sink of the soles: a foot that lands
// meets this surface.
FeetMatrix surface_points(const PlannerInput& input, const Vector3& normal) noexcept {
  return input.p_feet + normal * input.sole_sink.transpose();
}

}  // namespace

void Stepping::start(const PlannerInput& input, const Vector3& ground_normal, bool walk,
                     const WalkVelocity& command, double height_offset) noexcept {
  begin(input, ground_normal, height_offset);
  schedule_.start(input.gains, walk, command);
}

void Stepping::start_recovery(const PlannerInput& input, const Vector3& ground_normal,
                              double height_offset) noexcept {
  begin(input, ground_normal, height_offset);
  schedule_.start_recovery(input.gains, leg_to_swing(input));
}

void Stepping::begin(const PlannerInput& input, const Vector3& ground_normal,
                     double height_offset) noexcept {
  may_stand_ = false;
  recovery_.start();
  feet_.start(input.p_feet);
  ground_.start(surface_points(input, ground_normal), input.state.contact, ground_normal,
                input.sole_sink.mean());
  sway_.start();
  const Eigen::Vector2d p = input.p_com.head<2>();
  body_.start(measured_motion(input), input.p_com.z() - ground_.height_of_soles(p) - height_offset);
}

void Stepping::plan(const PlannerInput& input, bool walk, const WalkVelocity& command,
                    const BodyMotion& offset, bool may_stop, Reference& reference) noexcept {
  const HorizontalMotion measured = motion_without_sway(input);
  may_stand_ = may_stop && (input.lost_leg >= 0 || can_stand(input, measured));
  const bool steady = (measured.v_com - body_.v_world()).norm() < kSteadySpeed * size_.speed;
  update_schedule(input, walk, command, measured, steady);
  update_ground(input, steady);
  update_body(input, command, measured);
  body_.write(ground_, sway_, offset, input.delay, reference);
  // For those who compare base and reference: the QP moves the centre of mass.
  reference.p_base = reference.p_com + input.state.q.head<3>() - input.p_com;
  reference.v_base = reference.v_com;
  reference.stepping = true;
  for (int leg = 0; leg < kLegs; ++leg) {
    feet_.plan(leg, input, schedule_, measured, body_, ground_, steady);
    feet_.write(leg, input, contacts(), reference.feet[leg]);
  }
}

HorizontalMotion Stepping::motion_without_sway(const PlannerInput& input) const noexcept {
  HorizontalMotion motion = measured_motion(input);
  motion.p_com -= sway_.p();
  motion.v_com -= sway_.v();
  return motion;
}

void Stepping::update_schedule(const PlannerInput& input, bool walk, const WalkVelocity& command,
                               const HorizontalMotion& measured, bool steady) noexcept {
  const bool walks = schedule_.pattern().walk;
  walk = walk && !recovery_.update(input, schedule_, measured, body_, sway_);
  const Eigen::Vector4d contact = feet_.judge_contacts(input, schedule_, ground_, steady);
  if (walks && !walk)
    schedule_.trot_at_once(input.gains, body_.velocity(), leg_to_swing(input), feet_.stumble());
  schedule_.update_pattern(input.gains, walk, command, body_.velocity());
  schedule_.advance(input, measured, body_, contact, feet_.stumble(), may_stand_);
}

void Stepping::update_ground(const PlannerInput& input, bool steady) noexcept {
  feet_.update_clearance(input, contacts(), ground_, steady, size_.fastest_hip(body_.velocity()));
  const FeetMatrix points = surface_points(input, ground_.normal());
  for (int leg = 0; leg < kLegs; ++leg) {
    if (contacts().phase(leg) == FootPhase::kStance) ground_.stand_at(leg, points.col(leg));
  }
  ground_.update(size_.time, input.p_com.head<2>(), input.sole_sink.mean(), input.dt);
}

void Stepping::update_body(const PlannerInput& input, const WalkVelocity& command,
                           const HorizontalMotion& measured) noexcept {
  const StepPattern& pattern = schedule_.pattern();
  const WalkVelocity target = schedule_.needs_rest() ? WalkVelocity() : command;
  const double share = acceleration_share(pattern, input.gains, size_, target, body_.velocity());
  body_.update(input.gains, target, measured, share, input.dt);
  sway_.update(sway_input({pattern, size_, clock(), contacts(), body_, footholds()}, input),
               input.dt);
}

// The commanded body is at rest, all feet are near their places in the nominal stance, and a stand
// can stop the body over them.
bool Stepping::can_stand(const PlannerInput& input,
                         const HorizontalMotion& measured) const noexcept {
  if (body_.velocity().yaw_rate != 0.0 || !body_.v_world().isZero()) return false;
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(body_.yaw()).toRotationMatrix();
  // Of each foot: the body's position from which the foot is in its nominal place.
  const Eigen::Matrix<double, 2, kLegs> centres =
      input.p_feet.topRows<2>() - R * size_.nominal_feet.topRows<2>();
  const Eigen::Vector2d centre = centres.rowwise().mean();
  const double distance = (centres.colwise() - centre).colwise().norm().maxCoeff();
  const Eigen::Vector2d offset = measured.p_com - centre;
  const Eigen::Vector2d capture = offset + size_.time * measured.v_com;
  return distance <= kStopDistance * size_.height && offset.norm() <= kStopCapture * size_.height &&
         capture.norm() <= kStopCapture * size_.height;
}

}  // namespace surefoot
