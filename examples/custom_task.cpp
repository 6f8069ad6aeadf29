// SPDX-License-Identifier: BSD-3-Clause
// A user task that keeps a camera on the trunk at a given height. Any Pinocchio frame works the
// same way.
//   surefoot export go1 go1.robot
#include <cstdio>
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <surefoot/surefoot.hpp>

struct CameraHeight : surefoot::Task {
  explicit CameraHeight(const pinocchio::Model& robot) : model(robot), data(robot) {}
  int rows() const override { return 1; }
  // The vertical acceleration of the camera is J a + drift; its desired value is PD feedback.
  bool write(const surefoot::RobotState& state, surefoot::TaskRows& rows) noexcept override {
    const auto axes = pinocchio::LOCAL_WORLD_ALIGNED;
    pinocchio::forwardKinematics(model, data, state.q, state.v, Eigen::VectorXd::Zero(18));
    pinocchio::computeJointJacobians(model, data, state.q);
    pinocchio::getFrameJacobian(model, data, 1, camera, axes, J);
    const double speed = getFrameVelocity(model, data, 1, camera, axes).linear()[2];
    const double drift = getFrameClassicalAcceleration(model, data, 1, camera, axes).linear()[2];
    height = data.oMi[1].act(camera).translation().z();
    rows.A_a = J.row(2);
    rows.weight[0] = 3.0;  // large: the row is in m/s^2, built-in tasks are scaled to about g
    rows.b[0] = 100.0 * (target_height - height) - 20.0 * speed - drift;
    return true;
  }
  const pinocchio::SE3 camera{surefoot::Matrix3::Identity(), surefoot::Vector3(0.3, 0.0, 0.05)};
  const pinocchio::Model& model;
  pinocchio::Data data;
  pinocchio::Data::Matrix6x J = pinocchio::Data::Matrix6x::Zero(6, 18);
  double target_height = 0.08, height = 0.0;  // [m] 3 cm above the start
};

int main(int argc, char** argv) {
  const surefoot::Robot robot = surefoot::Robot::load(argc > 1 ? argv[1] : "go1.robot");
  surefoot::WholeBodyController controller(robot);
  const auto task = std::make_shared<CameraHeight>(robot.model());
  controller.add_task(task);
  surefoot::RobotState state;
  state.q = robot.q_standing();
  const surefoot::Reference reference = controller.hold(state);
  for (int tick = 0; tick < 1000; ++tick) {  // 2 s; the robot follows the accelerations exactly
    state.v += 0.002 * controller.update(state, reference).accelerations;
    state.q = pinocchio::integrate(robot.model(), state.q, 0.002 * state.v);
  }
  std::printf("camera at %.3f m, desired %.3f m\n", task->height, task->target_height);
}
