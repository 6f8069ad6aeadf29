// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/quadruped_dynamics.hpp"

#include <cmath>
#include <pinocchio/multibody.hpp>

#include "dynamics/generated/leg_dynamics.hpp"
#include "dynamics/pinocchio_dynamics.hpp"

namespace surefoot {

namespace {

namespace code = leg_code;

// Two legs side by side; the compiler makes it one SSE2 or NEON register.
typedef double Pair __attribute__((vector_size(16)));
constexpr int kPairs = kLegs / 2;

pinocchio::JointIndex joint_of(const Robot& robot, int motor) {
  return robot.model().getJointId(robot.config().joint_names[motor]);
}

// The code's parameters, in its order, of the joint that a motor drives and the body behind it.
double* write_joint(const Robot& robot, int motor, double* out) {
  const auto& model = robot.model();
  const auto joint = joint_of(robot, motor);
  const auto& inertia = model.inertias[joint];
  for (int i = 0; i < 3; ++i) *out++ = model.jointPlacements[joint].translation()[i];
  *out++ = inertia.mass();
  for (int i = 0; i < 3; ++i) *out++ = inertia.lever()[i];
  for (int i = 0; i < 6; ++i) *out++ = inertia.inertia().data()[i];
  *out++ = model.armature[robot.motor_to_v()[motor]];
  return out;
}

// One leg's half of the results, read in the order of Eigen's columns.
struct Half {
  const Pair* results;
  int half;
  double operator[](int i) const { return results[i][half]; }
  template <typename Matrix>
  void read(int first, Matrix& out) const {
    for (int i = 0; i < out.size(); ++i) out.data()[i] = (*this)[first + i];
  }
  // From the upper triangle, column by column.
  void read_symmetric(int first, Matrix3& out) const {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i <= j; ++i) out(i, j) = out(j, i) = (*this)[first + j * (j + 1) / 2 + i];
    }
  }
  Vector3 vector(int first) const {
    return {(*this)[first], (*this)[first + 1], (*this)[first + 2]};
  }
};

}  // namespace

struct QuadrupedDynamics::Work {
  explicit Work(const Robot& robot);
  void write_base(const TickDynamics& now, const Vector3& ground_normal) noexcept;
  void write_legs(const Eigen::VectorXd& q, const Eigen::VectorXd& v) noexcept;
  void read_leg(int leg, TickDynamics& out) const noexcept;
  void add_up(TickDynamics& out) const noexcept;

  Pair packed[kPairs][code::kPacked];
  Pair base[code::kBase];
  Pair legs[kPairs][code::kLeg];
  Pair results[kPairs][code::kResults];

  // The base's own body: mass, mass times centre, rotational inertia about the base's origin.
  double base_mass, mass;
  Vector3 base_mass_lever;
  Matrix3 base_inertia;
  Vector3 gravity;  ///< world axes [m/s^2]
  double foot_radius;
  std::array<int, kMotors> motor_to_q, motor_to_v;
};

QuadrupedDynamics::Work::Work(const Robot& robot)
    : mass(robot.mass()),
      gravity(robot.model().gravity.linear()),
      foot_radius(robot.config().foot_radius),
      motor_to_q(robot.motor_to_q()),
      motor_to_v(robot.motor_to_v()) {
  const auto& model = robot.model();
  const auto& body = model.inertias[1];
  base_mass = body.mass();
  base_mass_lever = body.mass() * body.lever();
  base_inertia = body.matrix().bottomRightCorner<3, 3>();
  for (int leg = 0; leg < kLegs; ++leg) {
    double parameters[code::kParameters], constants[code::kPacked];
    double* next = parameters;
    for (int k = 0; k < kLegJoints; ++k) next = write_joint(robot, 3 * leg + k, next);
    const Vector3& foot = model.frames[robot.foot_frame_ids()[leg]].placement.translation();
    for (int i = 0; i < 3; ++i) *next++ = foot[i];
    code::pack_leg(parameters, constants);
    for (int i = 0; i < code::kPacked; ++i) packed[leg / 2][i][leg % 2] = constants[i];
  }
}

void QuadrupedDynamics::Work::write_base(const TickDynamics& now,
                                         const Vector3& ground_normal) noexcept {
  const auto write = [this](int first, const Vector3& value) {
    for (int i = 0; i < 3; ++i) base[first + i] = Pair{value[i], value[i]};
  };
  write(0, now.v_base);
  write(3, now.w_base);
  for (int k = 0; k < 3; ++k) write(6 + 3 * k, now.R_world_base.col(k));
  write(15, now.R_world_base.transpose() * gravity);
  write(18, now.R_world_base.transpose() * (foot_radius * ground_normal));
}

void QuadrupedDynamics::Work::write_legs(const Eigen::VectorXd& q,
                                         const Eigen::VectorXd& v) noexcept {
  for (int motor = 0; motor < kMotors; ++motor) {
    const int leg = motor / 3, k = motor % 3;
    const double angle = q[motor_to_q[motor]];
    legs[leg / 2][2 * k][leg % 2] = std::cos(angle);
    legs[leg / 2][2 * k + 1][leg % 2] = std::sin(angle);
    legs[leg / 2][6 + k][leg % 2] = v[motor_to_v[motor]];
  }
}

void QuadrupedDynamics::Work::read_leg(int leg, TickDynamics& out) const noexcept {
  const Half half{results[leg / 2], leg % 2};
  LegDynamics& L = out.legs[leg];
  half.read(code::kHLeg, L.h_leg);
  half.read(code::kMBaseLeg, L.M_base_leg);
  half.read_symmetric(code::kMLeg, L.M_leg);
  L.p_world_contact = out.p_world_base + half.vector(code::kPContact);
  half.read(code::kVContact, L.v_world_contact);
  half.read(code::kDrift, L.drift);
  half.read(code::kJLeg, L.J_leg);
  L.J_base.leftCols<3>() = out.R_world_base;
  for (int i = 0; i < 9; ++i) L.J_base.data()[9 + i] = half[code::kJBaseAngular + i];
  L.depth = half[code::kDepth];
}

// The base's own body and the four legs make the robot: inertia, momentum and bias about the base's
// origin, in base axes, add.
void QuadrupedDynamics::Work::add_up(TickDynamics& out) const noexcept {
  Pair sum[code::kShared];
  for (int i = 0; i < code::kShared; ++i) sum[i] = results[0][i] + results[1][i];
  const auto total = [&sum](int i) { return sum[i][0] + sum[i][1]; };
  const auto vector = [&total](int i) { return Vector3(total(i), total(i + 1), total(i + 2)); };

  const Vector3 mass_lever = base_mass_lever + vector(code::kMassLever);
  Matrix3 inertia;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i <= j; ++i) {
      const double entry = base_inertia(i, j) + total(code::kInertia + j * (j + 1) / 2 + i);
      inertia(i, j) = inertia(j, i) = entry;
    }
  }
  const Matrix3 cross = skew(mass_lever);
  out.M_base.topLeftCorner<3, 3>() = mass * Matrix3::Identity();
  out.M_base.topRightCorner<3, 3>() = -cross;
  out.M_base.bottomLeftCorner<3, 3>() = cross;
  out.M_base.bottomRightCorner<3, 3>() = inertia;

  // Newton and Euler for the base's own body (Featherstone 2008, eq. 2.66), gravity as
  // acceleration.
  const Vector3 &v = out.v_base, &w = out.w_base;
  const Vector3 g(base[15][0], base[16][0], base[17][0]);
  const Vector3 linear = base_mass * v + w.cross(base_mass_lever);
  const Vector3 angular = base_mass_lever.cross(v) + base_inertia * w;
  out.h_base.head<3>() = vector(code::kHBase) + w.cross(linear) - base_mass * g;
  out.h_base.tail<3>() =
      vector(code::kHBase + 3) + w.cross(angular) + v.cross(linear) - base_mass_lever.cross(g);

  const Vector3 p_base_com = mass_lever / mass;
  const Matrix3 about_com = inertia + skew(p_base_com) * cross;
  const Vector3 p = mass * v + w.cross(mass_lever) + vector(code::kMomentum);
  const Vector3 L = mass_lever.cross(v) + inertia * w + vector(code::kMomentum + 3);
  const Matrix3& R = out.R_world_base;
  out.I_world_com = R * about_com * R.transpose();
  out.p_world_com = out.p_world_base + R * p_base_com;
  out.v_world_com = R * p / mass;
  out.L_world_com = R * (L - p_base_com.cross(p));
}

bool QuadrupedDynamics::fits(const Robot& robot) noexcept {
  const auto& model = robot.model();
  const auto level = [](const Matrix3& R) { return R.isIdentity(1e-12); };
  if (!has_chains_of_three(robot) || !model.jointPlacements[1].isIdentity(1e-12) ||
      !model.armature.head<6>().isZero(0.0)) {
    return false;
  }
  const std::string shape[] = {"JointModelRX", "JointModelRY", "JointModelRY"};
  for (int motor = 0; motor < kMotors; ++motor) {
    const auto joint = joint_of(robot, motor);
    if (model.joints[joint].shortname() != shape[motor % 3]) return false;
    if (!level(model.jointPlacements[joint].rotation())) return false;
  }
  return true;
}

QuadrupedDynamics::QuadrupedDynamics(const Robot& robot) : work_(std::make_unique<Work>(robot)) {}
QuadrupedDynamics::~QuadrupedDynamics() = default;

void QuadrupedDynamics::update(const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                               const Vector3& ground_normal, TickDynamics& out) noexcept {
  out.R_world_base = Eigen::Map<const Quaternion>(q.data() + 3).toRotationMatrix();
  out.p_world_base = q.head<3>();
  out.v_base = v.head<3>();
  out.w_base = v.segment<3>(3);
  out.v_world_base = out.R_world_base * out.v_base;
  Work& work = *work_;
  work.write_base(out, ground_normal);
  work.write_legs(q, v);
  for (int pair = 0; pair < kPairs; ++pair) {
    code::leg_dynamics(work.packed[pair], work.base, work.legs[pair], work.results[pair]);
  }
  work.add_up(out);
  for (int leg = 0; leg < kLegs; ++leg) work.read_leg(leg, out);
}

}  // namespace surefoot
