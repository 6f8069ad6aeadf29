// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "surefoot/body_reference.hpp"
#include "surefoot/controller.hpp"

namespace surefoot {

class WalkPlanner;

/// Controller that holds the body at the latched pose, or moves it to a BodyReference.
///
/// Its planner latches the pose of the body relative to the feet in the first good samples. After a
/// strong push the robot steps (gain recovery_margin), until its feet are in the nominal stance,
/// and latches the pose in which it stands. After a lost leg, it moves the centre of mass over the
/// other three feet. It estimates the normal of the ground plane under the feet.
class StandController : public Controller {
 public:
  /// Create a controller with RobotConfig::gains and default options. Throws surefoot::Error if the
  /// robot does not have twelve joints on a free base, or if a gain or an option is invalid.
  explicit StandController(const Robot& robot);
  /// The same with other gains than RobotConfig::gains.
  StandController(const Robot& robot, const Gains& gains, const ControllerOptions& options = {});
  ~StandController() override;
  /// Take over the content of another StandController, which may only be destroyed afterwards.
  StandController(StandController&&) noexcept;

  /// Set the target pose of the body; reset() clears it. The reference moves to the target with
  /// limited speed and acceleration, and stops at the limits of ReachLimit. A target with a NaN or
  /// an infinity is ignored, and reach() reports kNotFinite. Real-time: yes.
  void set_body_reference(const BodyReference& target) noexcept;
  BodyReference body_reference() const noexcept;  ///< present reference, which moves to the target
  ReachStatus reach() const noexcept;  ///< limit that stops the reference before the target

  /// Compute the distance [m] from the capture point to the nearest edge of the support triangle
  /// that remains without `leg`. The newest state estimate is used. Negative: outside the triangle.
  /// Infinity: another leg is already lost. NaN: `leg` is not 0 .. 3, or no pose is latched yet.
  /// Real-time: yes.
  double capture_margin_without(int leg) const noexcept;

 protected:
  /// Create a controller with a planner that a derived class configures.
  StandController(const Robot& robot, std::shared_ptr<WalkPlanner> planner, const Gains& gains,
                  const ControllerOptions& options);
  /// Return the planner of stand and walk. Real-time: yes.
  WalkPlanner& planner() noexcept { return *planner_; }
  /// The same, for reading. Real-time: yes.
  const WalkPlanner& planner() const noexcept { return *planner_; }

 private:
  std::shared_ptr<WalkPlanner> planner_;
};

}  // namespace surefoot
