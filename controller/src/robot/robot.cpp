// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/robot.hpp"

#include <algorithm>
#include <locale>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <pinocchio/multibody.hpp>
#include <pinocchio/serialization.hpp>
#include <sstream>

#include "common/text.hpp"
#include "robot/robot_checks.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

// Data of a Robot, shared by its copies.
struct Robot::Data {
  pinocchio::Model model;
  RobotConfig config;
  std::array<int, kMotors> motor_to_v;
  std::array<int, kMotors> motor_to_q;
  std::array<int, kLegs> foot_frame_ids;
  double mass;
  std::vector<std::string> doubts;
};

namespace {

void check_base(const pinocchio::Model& model, const RobotConfig& config) {
  const bool free_flyer =
      model.njoints > 1 && model.joints[1].nq() == 7 && model.joints[1].nv() == 6;
  if (!free_flyer) {
    throw Error("robot '" + config.name + "': the model's first joint is " +
                (model.njoints > 1
                     ? "'" + model.names[1] + "' (" + model.joints[1].shortname() + ")"
                     : std::string("missing")) +
                ", expected a free-flyer; build the model with a JointModelFreeFlyer root");
  }
  for (int joint = 2; joint < model.njoints; ++joint) {
    if (model.joints[joint].nv() != 1) {
      fail_check(config, "joint '" + model.names[joint] + "'", model.joints[joint].shortname(),
                 "one free-flyer at the root, and joints of one axis below it");
    }
  }
}

void match_joints(const pinocchio::Model& model, const RobotConfig& config, Robot::Data& data) {
  std::vector<std::string> valid(model.names.begin() + 2, model.names.end());
  for (int i = 0; i < kMotors; ++i) {
    const std::string& name = config.joint_names[i];
    if (!model.existJointName(name)) {
      throw Error("robot '" + config.name + "': missing joint '" + name + "' (motor " +
                  std::to_string(i) + ")" + suggestion(name, valid) +
                  "; the model has: " + join(valid));
    }
    const auto& joint = model.joints[model.getJointId(name)];
    if (joint.nq() != 1 || joint.nv() != 1) {
      throw Error("robot '" + config.name + "': joint '" + name + "' is a " + joint.shortname() +
                  ", expected a bounded one-axis joint");
    }
    data.motor_to_q[i] = joint.idx_q();
    data.motor_to_v[i] = joint.idx_v();
  }
}

// Check that each leg is one chain from base to foot. Names in a wrong order would mix two legs.
void check_chains(const pinocchio::Model& model, const RobotConfig& config) {
  for (int leg = 0; leg < kLegs; ++leg) {
    for (int k = 1; k < kLegJoints; ++k) {
      const std::string& parent_name = config.joint_names[3 * leg + k - 1];
      const std::string& child_name = config.joint_names[3 * leg + k];
      const auto& chain = model.supports[model.getJointId(child_name)];
      if (std::find(chain.begin(), chain.end(), model.getJointId(parent_name)) == chain.end()) {
        throw Error("robot '" + config.name + "': joint '" + child_name +
                    "' is not a descendant of joint '" + parent_name +
                    "', expected hip, thigh and calf of one leg, in this order");
      }
    }
  }
}

void match_feet(const pinocchio::Model& model, const RobotConfig& config, Robot::Data& data) {
  for (int leg = 0; leg < kLegs; ++leg) {
    const std::string& name = config.foot_frames[leg];
    // A body and a joint may have the same name: take the first frame with this name.
    int id = -1;
    std::vector<std::string> names;
    for (std::size_t k = 0; k < model.frames.size(); ++k) {
      names.push_back(model.frames[k].name);
      if (id < 0 && model.frames[k].name == name) id = static_cast<int>(k);
    }
    if (id < 0) {
      throw Error("robot '" + config.name + "': missing foot frame '" + name + "'" +
                  suggestion(name, names) + "; the model has: " + join(names));
    }
    if (model.frames[id].parentJoint != model.getJointId(config.joint_names[3 * leg + 2])) {
      throw Error("robot '" + config.name + "': foot frame '" + name + "' is attached to joint '" +
                  model.names[model.frames[id].parentJoint] + "', expected the calf joint '" +
                  config.joint_names[3 * leg + 2] + "'");
    }
    data.foot_frame_ids[leg] = id;
  }
}

// Return whether the twelve motors drive four legs on the base. A WholeBodyController also takes a
// humanoid, whose legs and arms are given as the four legs.
bool has_four_legs(const pinocchio::Model& model, const RobotConfig& config) {
  const auto at_base = [&](int leg) {
    return model.parents[model.getJointId(config.joint_names[kLegJoints * leg])] == 1;
  };
  return model.nv == 6 + kMotors || (at_base(0) && at_base(1) && at_base(2) && at_base(3));
}

}  // namespace

Robot::Robot(const pinocchio::Model& model, const RobotConfig& config) {
  config.validate();
  check_base(model, config);
  auto data = std::make_shared<Data>(Data{model, config, {}, {}, {}, 0.0, {}});
  match_joints(model, config, *data);
  check_chains(model, config);
  match_feet(model, config, *data);
  for (int i = 0; i < kMotors; ++i) data->model.armature[data->motor_to_v[i]] = config.armature[i];
  for (const auto& inertia : data->model.inertias) data->mass += inertia.mass();
  const RobotParts parts{data->model, data->config, data->motor_to_q, data->motor_to_v,
                         data->foot_frame_ids};
  check_bodies(parts, data->doubts);
  if (has_four_legs(model, config)) {
    const auto legs = measure_legs(parts);
    check_legs(data->config, legs, data->doubts);
    check_torque_limits(parts, legs, data->doubts);
  }
  data_ = std::move(data);
}

Robot Robot::from_serialized_model(const std::string& text, const RobotConfig& config) {
  pinocchio::Model model;
  try {
    std::istringstream in(text);
    in.imbue(std::locale::classic());
    model.loadFromStringStream(in);
  } catch (const std::exception& problem) {
    throw Error("robot '" + config.name + "': the serialised model cannot be read (" +
                problem.what() + "); it must come from the same Pinocchio version");
  }
  return Robot(model, config);
}

const pinocchio::Model& Robot::model() const noexcept { return data_->model; }
const RobotConfig& Robot::config() const noexcept { return data_->config; }

std::string Robot::serialized_model() const {
  std::stringstream out;
  out.imbue(std::locale::classic());
  data_->model.saveToStringStream(out);
  return out.str();
}

int Robot::nq() const noexcept { return data_->model.nq; }
int Robot::nv() const noexcept { return data_->model.nv; }
double Robot::mass() const noexcept { return data_->mass; }
const std::vector<std::string>& Robot::doubts() const noexcept { return data_->doubts; }
const std::array<int, kMotors>& Robot::motor_to_v() const noexcept { return data_->motor_to_v; }
const std::array<int, kMotors>& Robot::motor_to_q() const noexcept { return data_->motor_to_q; }
const std::array<int, kLegs>& Robot::foot_frame_ids() const noexcept {
  return data_->foot_frame_ids;
}

Eigen::VectorXd Robot::q_standing() const {
  Eigen::VectorXd q = pinocchio::neutral(data_->model);
  for (int i = 0; i < kMotors; ++i) q[data_->motor_to_q[i]] = data_->config.q_standing[i];
  return q;
}

}  // namespace surefoot
