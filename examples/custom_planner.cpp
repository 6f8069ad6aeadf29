// SPDX-License-Identifier: BSD-3-Clause
// A planner of your own: the body moves on a circle. Start surefoot robot --robot go1 first, then
//   surefoot export go1 go1.robot; custom_planner go1.robot [--port N] [--duration S]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <surefoot/surefoot.hpp>
#include <thread>

using namespace surefoot;

struct Circle : Planner {
  bool plan(const PlannerInput& input, Reference& reference) noexcept override {
    const Vector3 feet = input.p_feet.rowwise().mean();
    if (time == 0.0) {
      center = input.p_com - feet;
      reference.R_world_base = Quaternion(input.R_world_base);
    }
    time += input.dt;
    const double angle = rate * time, radius = 0.02 * std::min(time / ramp, 1.0);
    const double growth = time < ramp ? 0.02 / ramp : 0.0;  // [m/s]
    const Vector3 radial(std::cos(angle), std::sin(angle), 0.0);
    const Vector3 tangent(-radial.y(), radial.x(), 0.0);
    reference.p_com = feet + center + radius * radial;
    reference.v_com = growth * radial + radius * rate * tangent;
    reference.a_com = 2.0 * growth * rate * tangent - radius * rate * rate * radial;
    for (int leg = 0; leg < kLegs; ++leg) reference.feet[leg].p_world = input.p_feet.col(leg);
    return true;
  }
  void reset() noexcept override { time = 0.0; }
  const double rate = 3.14, ramp = 4.0;  // [rad/s]; [s] time until the radius is reached
  double time = 0.0;
  Vector3 center;  // [m] from the mean of the feet, whose position may drift
};

int main(int argc, char** argv) {
  UdpLinkOptions options;
  double duration = 10.0;
  for (int k = 2; k + 1 < argc; k += 2) {
    if (!std::strcmp(argv[k], "--port")) options.port = std::atoi(argv[k + 1]);
    if (!std::strcmp(argv[k], "--duration")) duration = std::atof(argv[k + 1]);
  }
  const Robot robot = Robot::load(argc > 1 ? argv[1] : "go1.robot");
  Controller controller(robot, std::make_shared<Circle>());
  Safety safety(robot);
  UdpLink link(options);
  LowCmd command = damping_low_cmd(3.0);  // the robot only replies to senders of frames
  for (int n = 0; n < duration / 0.002; ++n) {
    if (link.receive()) {
      command = controller.update(link.state());
      if (safety.power_protect(command, link.state(), 1) < 0) break;
    } else if (link.state_age() > 0.01) {
      command = damping_low_cmd(3.0);
    }
    link.send(command);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  for (int k = 0; k < 100; ++k)
    link.send(damping_low_cmd(3.0));  // the robot keeps the last command
  return is_usable(controller.status()) ? 0 : 1;
}
