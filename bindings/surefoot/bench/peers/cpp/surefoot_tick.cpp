// SPDX-License-Identifier: BSD-3-Clause
// Surefoot's ticks in C++: from RobotState to torques, or from LowState to LowCmd.
#include <cstring>
#include <surefoot/surefoot.hpp>

#include "worker_loop.hpp"

namespace {

class StateToTorque {
 public:
  explicit StateToTorque(const peers::Problem& problem)
      : problem_(problem),
        controller_(surefoot::Robot::load(problem.folder + "point.robot")),
        state_(problem.nq, problem.nv) {
    state_.q = problem.q(0);
    state_.v = problem.v(0);
    reference_ = controller_.hold(state_);
  }

  void load(int tick) {
    state_.q = problem_.q(tick);
    state_.v = problem_.v(tick);
    reference_.p_com = problem_.com(tick);
    reference_.R_world_base = problem_.base(tick);
  }

  void tick() { solution_ = &controller_.update(state_, reference_); }

  void read_result(peers::TickResult& out) const {
    out.solved = surefoot::is_usable(solution_->status);
    out.forces = Eigen::Map<const Eigen::VectorXd>(solution_->forces.data(), 12);
    out.torques = solution_->torques;
  }

 private:
  const peers::Problem& problem_;
  surefoot::WholeBodyController controller_;
  surefoot::RobotState state_;
  surefoot::Reference reference_;
  const surefoot::Solution* solution_ = nullptr;
};

class WholeTick {
 public:
  explicit WholeTick(const peers::Problem& problem)
      : controller_(surefoot::Robot::load(problem.folder + "whole.robot")) {
    low_states_.resize(problem.ticks);
    std::ifstream file(problem.folder + "reports.bin", std::ios::binary);
    if (!file.read(reinterpret_cast<char*>(low_states_.data()),
                   low_states_.size() * sizeof(surefoot::LowState))) {
      throw std::runtime_error(problem.folder + "reports.bin: too short");
    }
  }

  void load(int tick) {
    if (tick == 0) controller_.reset();  // otherwise the controller's clock would go backwards
    low_state_ = &low_states_[tick];
  }

  void tick() { controller_.update(*low_state_); }

  void read_result(peers::TickResult& out) const {
    out.solved = surefoot::is_usable(controller_.status());
  }

 private:
  surefoot::StandController controller_;
  std::vector<surefoot::LowState> low_states_;
  const surefoot::LowState* low_state_ = nullptr;
};

template <typename Implementation>
void serve_ticks(const peers::Problem& problem) {
  Implementation implementation(problem);
  peers::serve(problem, implementation, "{}");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const peers::Problem problem(argc > 1 ? argv[1] : "problem.txt");
    const bool whole = argc > 2 && std::strcmp(argv[2], "tick") == 0;
    whole ? serve_ticks<WholeTick>(problem) : serve_ticks<StateToTorque>(problem);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "surefoot_tick: %s\n", error.what());
    return 1;
  }
  return 0;
}
