// SPDX-License-Identifier: BSD-3-Clause
// TSID's tick in C++: computeProblemData, solve, getActuatorForces. See workers/tsid_worker.py.
#include <memory>
#include <tsid/contacts/contact-point.hpp>
#include <tsid/formulations/inverse-dynamics-formulation-acc-force.hpp>
#include <tsid/robots/robot-wrapper.hpp>
#include <tsid/solvers/solver-HQP-eiquadprog-fast.hpp>
#include <tsid/solvers/solver-HQP-eiquadprog-rt.hpp>
#include <tsid/solvers/solver-HQP-eiquadprog-rt.hxx>
#include <tsid/tasks/task-actuation-bounds.hpp>
#include <tsid/tasks/task-com-equality.hpp>
#include <tsid/tasks/task-joint-posture.hpp>
#include <tsid/tasks/task-se3-equality.hpp>

#include "worker_loop.hpp"

namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

class Tsid {
 public:
  explicit Tsid(const peers::Problem& problem)
      : problem_(problem),
        robot_(problem.folder + "robot.urdf", {}, pinocchio::JointModelFreeFlyer(), false) {
    check_joints();
    robot_.rotor_inertias(problem.array("armature"));
    robot_.gear_ratios(VectorXd::Ones(problem.nv - 6));
    formulation_ = std::make_unique<tsid::InverseDynamicsFormulationAccForce>("tsid", robot_);
    formulation_->computeProblemData(0.0, problem.q(0), VectorXd::Zero(problem.nv));
    for (int leg = 0; leg < 4; ++leg) add_contact(leg);
    add_body();
    add_joints();
    make_solver(formulation_->nVar(), formulation_->nEq(), formulation_->nIn());
  }

  void load(int tick) {
    q_ = problem_.q(tick);
    v_ = problem_.v(tick);
    tsid::trajectories::TrajectorySample com_target(3);
    com_target.setValue(problem_.com(tick));
    com_->setReference(com_target);
    base_->setReference(pinocchio::SE3(problem_.base(tick), Vector3d::Zero()));
  }

  void tick() {
    const auto& data = formulation_->computeProblemData(0.0, q_, v_);
    solution_ = &solver_->solve(data);
    torques_ = &formulation_->getActuatorForces(*solution_);
  }

  void read_result(peers::TickResult& out) {
    out.solved = solution_->status == tsid::solvers::HQP_STATUS_OPTIMAL;
    for (int leg = 0; leg < 4; ++leg) {
      const std::string& foot = problem_.names("feet")[leg];
      out.forces.segment<3>(3 * leg) = formulation_->getContactForces(foot, *solution_);
    }
    out.torques = *torques_;
  }

 private:
  void check_joints() const {
    const auto& names = robot_.model().names;  // skip the universe and the root joint
    if (!std::equal(names.begin() + 2, names.end(), problem_.names("joints").begin(),
                    problem_.names("joints").end())) {
      throw std::runtime_error("joints: got another order than in the states");
    }
  }

  // eiquadprog-rt is faster, but its sizes must be known at compile time. The template
  // arguments are the sizes for four legs with three joints each.
  void make_solver(unsigned n, unsigned n_eq, unsigned n_in) {
    if (n == 30 && n_eq == 18 && n_in == 32) {
      solver_ = std::make_unique<tsid::solvers::SolverHQuadProgRT<30, 18, 32>>("solver");
    } else {
      solver_ = std::make_unique<tsid::solvers::SolverHQuadProgFast>("solver");
    }
    solver_->resize(n, n_eq, n_in);
  }

  void add_contact(int leg) {
    const std::string& foot = problem_.names("feet")[leg];
    const Vector3d up = Vector3d::UnitZ();
    auto contact = std::make_unique<tsid::contacts::ContactPoint>(
        foot, robot_, foot, up, problem_.number("friction"), 0.0, problem_.number("force_max"));
    const VectorXd gains = problem_.array("foot_gains");
    contact->Kp(gains[0] * Vector3d::Ones());
    contact->Kd(gains[1] * Vector3d::Ones());
    contact->useLocalFrame(false);  // otherwise forces and friction cone rotate with the foot
    const Vector3d anchor = problem_.array("anchors").segment<3>(3 * leg);
    contact->setReference(pinocchio::SE3(Eigen::Matrix3d::Identity(), anchor));
    contact->setRegularizationTaskWeightVector(Vector3d::Ones());
    contact->setForceReference(problem_.number("force") * up);
    formulation_->addRigidContact(*contact, problem_.number("force_weight"));
    contacts_.push_back(std::move(contact));
  }

  void add_body() {
    com_ = std::make_unique<tsid::tasks::TaskComEquality>("com", robot_);
    base_ = std::make_unique<tsid::tasks::TaskSE3Equality>("base", robot_, "root_joint");
    VectorXd rotation_mask(6);
    rotation_mask << 0.0, 0.0, 0.0, 1.0, 1.0, 1.0;
    base_->setMask(rotation_mask);
    load(0);
    add_motion(*com_, "com", 3);
    add_motion(*base_, "base", 6);
  }

  void add_joints() {
    const int joints = problem_.nv - 6;
    posture_ = std::make_unique<tsid::tasks::TaskJointPosture>("posture", robot_);
    tsid::trajectories::TrajectorySample pose(joints);
    pose.setValue(problem_.array("posture"));
    posture_->setReference(pose);
    add_motion(*posture_, "posture", joints);

    bounds_ = std::make_unique<tsid::tasks::TaskActuationBounds>("torques", robot_);
    bounds_->setBounds(-problem_.array("tau_max"), problem_.array("tau_max"));
    formulation_->addActuationTask(*bounds_, 1.0, 0, 0.0);
  }

  template <typename Task>
  void add_motion(Task& task, const std::string& name, int size) {
    const VectorXd gains = problem_.array(name + "_gains");
    task.Kp(gains[0] * VectorXd::Ones(size));
    task.Kd(gains[1] * VectorXd::Ones(size));
    formulation_->addMotionTask(task, problem_.number(name + "_weight"), 1, 0.0);
  }

  const peers::Problem& problem_;
  tsid::robots::RobotWrapper robot_;
  std::unique_ptr<tsid::InverseDynamicsFormulationAccForce> formulation_;
  std::vector<std::unique_ptr<tsid::contacts::ContactPoint>> contacts_;
  std::unique_ptr<tsid::tasks::TaskComEquality> com_;
  std::unique_ptr<tsid::tasks::TaskSE3Equality> base_;
  std::unique_ptr<tsid::tasks::TaskJointPosture> posture_;
  std::unique_ptr<tsid::tasks::TaskActuationBounds> bounds_;
  std::unique_ptr<tsid::solvers::SolverHQPBase> solver_;
  VectorXd q_, v_;
  const tsid::solvers::HQPOutput* solution_ = nullptr;
  const tsid::math::Vector* torques_ = nullptr;
};

}  // namespace

int main(int argc, char** argv) {
  try {
    const peers::Problem problem(argc > 1 ? argv[1] : "problem.txt");
    Tsid tsid(problem);
    peers::serve(problem, tsid, argc > 2 ? argv[2] : "{}");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tsid_tick: %s\n", error.what());
    return 1;
  }
  return 0;
}
