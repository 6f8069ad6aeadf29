// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <cmath>
#include <pinocchio/multibody.hpp>

#include "common/text.hpp"
#include "robot/robot_checks.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

namespace {

// [m] Bounds of a body's radius of gyration, the root of moment / mass. Chosen: thin calves have
// 12 mm, the trunk of a B1 has 0.3 m. Outside these bounds a unit is wrong (g.mm^2, or mm).
constexpr double kMinGyration = 1e-3, kMaxGyration = 2.0;
// [m] Greatest distance from a joint to the centre of mass of its body. Chosen: half the trunk of
// the largest quadrupeds has 0.5 m; more means mm.
constexpr double kMaxLever = 1.0;
// Share of the largest moment by which the other two may miss it: rounded numbers of thin rods.
constexpr double kTriangleTolerance = 1e-6;
constexpr double kUsualMass[2] = {3.0, 150.0};  // [kg] of quadrupeds, chosen
constexpr double kUsualBaseShare = 0.2;  // least share of the base in the mass, chosen: a1 has 0.35

// Name of the body: the link that the joint moves, followed by the links that are fixed to it.
std::string body_name(const pinocchio::Model& model, pinocchio::JointIndex joint) {
  std::string name;
  for (const auto& frame : model.frames) {
    if (frame.parentJoint != joint || frame.type != pinocchio::BODY) continue;
    if (name.empty()) {
      name = "'" + frame.name + "'";
    } else {
      return name + " with all links fixed to it";
    }
  }
  return name.empty() ? "of joint '" + model.names[joint] + "'" : name;
}

void check_moments(const RobotConfig& config, const std::string& what, double mass,
                   const Vector3& moments) {
  const std::string got = to_text(moments[0]) + ", " + to_text(moments[1]) + ", " +
                          to_text(moments[2]) + " kg.m^2 (principal moments)";
  if (moments[0] + moments[1] < (1.0 - kTriangleTolerance) * moments[2] || !(moments[0] > 0.0)) {
    fail_check(config, what + ", inertia", got,
               "moments > 0, and no moment above the sum of the other two; correct its <inertia>");
  }
  if (moments[0] < kMinGyration * kMinGyration * mass) {
    fail_check(config, what + ", inertia", got,
               "at least (1 mm)^2 times its mass of " + to_text(mass) +
                   " kg; correct <inertia>, in kg.m^2");
  }
  if (moments[2] > kMaxGyration * kMaxGyration * mass) {
    fail_check(
        config, what + ", inertia", got,
        "at most (2 m)^2 times its mass of " + to_text(mass) + " kg; correct <inertia>, in kg.m^2");
  }
}

}  // namespace

void fail_check(const RobotConfig& config, const std::string& what, const std::string& got,
                const std::string& expected) {
  throw Error("robot '" + config.name + "', " + what + ": got " + got + ", expected " + expected);
}

void check_bodies(const RobotParts& parts, Doubts& doubts) {
  const auto& model = parts.model;
  double total = 0.0;
  for (int joint = 1; joint < model.njoints; ++joint) {
    const auto& inertia = model.inertias[joint];
    const std::string what = "body " + body_name(model, joint);
    const double mass = inertia.mass();
    if (!(std::isfinite(mass) && mass > 0.0)) {
      fail_check(parts.config, what + ", mass", to_text(mass) + " kg",
                 "a mass above 0, because joint '" + model.names[joint] +
                     "' moves it; give the link an <inertial>");
    }
    const Vector3 lever = inertia.lever();
    if (!(lever.norm() <= kMaxLever)) {
      fail_check(parts.config, what + ", centre of mass",
                 to_text(lever.norm()) + " m from its joint",
                 "at most 1 m; correct the <origin> of <inertial>, in m");
    }
    const Matrix3 matrix = inertia.inertia().matrix();
    if (!matrix.allFinite()) {
      fail_check(parts.config, what + ", inertia", "NaN or infinity", "finite numbers, in kg.m^2");
    }
    check_moments(
        parts.config, what, mass,
        Eigen::SelfAdjointEigenSolver<Matrix3>(matrix, Eigen::EigenvaluesOnly).eigenvalues());
    total += mass;
  }
  if (total < kUsualMass[0] || total > kUsualMass[1]) {
    doubts.push_back("total mass: " + to_text(total) + " kg is unusual for a quadruped (" +
                     to_text(kUsualMass[0]) + " .. " + to_text(kUsualMass[1]) + " kg)");
  }
  if (model.inertias[1].mass() < kUsualBaseShare * total) {
    doubts.push_back("body " + body_name(model, 1) + ": the base has " +
                     to_text(model.inertias[1].mass()) + " kg of " + to_text(total) +
                     " kg; the trunk of a quadruped usually has at least a fifth");
  }
}

}  // namespace surefoot
