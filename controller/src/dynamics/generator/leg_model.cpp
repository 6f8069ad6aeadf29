// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/generator/leg_model.hpp"

// clang-format off: Pinocchio's CasADi header must come before all other headers of Pinocchio.
#include <pinocchio/autodiff/casadi.hpp>
#include <pinocchio/multibody.hpp>
// clang-format on
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>

namespace surefoot::generator {

// Joint types of a base with one leg, and the mimic joint, which ModelTpl requires. Pinocchio's
// default list has two dozen types, and each type costs seconds of compile time.
template <typename Scalar, int Options>
struct LegJoints {
  using JointModelVariant = boost::variant<
      pinocchio::JointModelFreeFlyerTpl<Scalar, Options>,
      pinocchio::JointModelRevoluteUnboundedTpl<Scalar, Options, 0>,
      pinocchio::JointModelRevoluteUnboundedTpl<Scalar, Options, 1>,
      boost::recursive_wrapper<pinocchio::JointModelMimicTpl<Scalar, Options, LegJoints>>>;
  using JointDataVariant = boost::variant<
      pinocchio::JointDataFreeFlyerTpl<Scalar, Options>,
      pinocchio::JointDataRevoluteUnboundedTpl<Scalar, Options, 0>,
      pinocchio::JointDataRevoluteUnboundedTpl<Scalar, Options, 1>,
      boost::recursive_wrapper<pinocchio::JointDataMimicTpl<Scalar, Options, LegJoints>>>;
};

namespace {

using casadi::SX;
using VectorX = Eigen::Matrix<SX, Eigen::Dynamic, 1>;
using Vector3 = Eigen::Matrix<SX, 3, 1>;
using Matrix3 = Eigen::Matrix<SX, 3, 3>;
using LegModel = pinocchio::ModelTpl<SX, 0, LegJoints>;
using LegData = pinocchio::DataTpl<SX, 0, LegJoints>;

// Reads the entries of a column one by one. The order of the calls defines the layout of the
// column.
struct EntryReader {
  SX symbols;
  int next = 0;
  SX scalar() { return symbols(next++); }
  Vector3 vector() {
    Vector3 out;
    for (int i = 0; i < 3; ++i) out[i] = scalar();
    return out;
  }
};

template <typename Derived>
void append(const Eigen::MatrixBase<Derived>& m, std::vector<SX>& out) {
  for (Eigen::Index j = 0; j < m.cols(); ++j) {
    for (Eigen::Index i = 0; i < m.rows(); ++i) out.push_back(m(i, j));
  }
}

template <typename Derived>
void append_symmetric(const Eigen::MatrixBase<Derived>& m, std::vector<SX>& out) {
  for (Eigen::Index j = 0; j < m.cols(); ++j) append(m.col(j).head(j + 1), out);
}

// Begin a new field, and return the vector to which the caller appends the entries of the field.
std::vector<SX>& add_field(LegExpressions& out, const std::string& name,
                           const std::string& meaning) {
  out.fields.push_back({name, meaning, static_cast<int>(out.results.size())});
  return out.results;
}

// Build the model of a leg. The joints are "unbounded": the coordinates of a joint are its cosine
// and sine, which the caller computes once.
LegModel leg_model(EntryReader parameters, Vector3& p_calf_foot) {
  LegModel model;
  const Matrix3 no_rotation = Matrix3::Identity();
  auto parent =
      model.addJoint(0, pinocchio::JointModelFreeFlyerTpl<SX>(), LegModel::SE3::Identity(), "base");
  const auto add = [&](const auto& joint, const std::string& name) {
    parent = model.addJoint(parent, joint, LegModel::SE3(no_rotation, parameters.vector()), name);
    LegModel::Inertia& inertia = model.inertias[parent];
    inertia.mass() = parameters.scalar();
    inertia.lever() = parameters.vector();
    for (int i = 0; i < 6; ++i) inertia.inertia().data()[i] = parameters.scalar();
    model.armature[model.idx_vs[parent]] = parameters.scalar();
  };
  add(pinocchio::JointModelRevoluteUnboundedTpl<SX, 0, 0>(), "hip");
  add(pinocchio::JointModelRevoluteUnboundedTpl<SX, 0, 1>(), "thigh");
  add(pinocchio::JointModelRevoluteUnboundedTpl<SX, 0, 1>(), "calf");
  p_calf_foot = parameters.vector();
  return model;
}

struct BaseState {
  Vector3 v, w;     // linear and angular velocity, base axes
  Matrix3 R;        // rotation from base to world axes
  Vector3 gravity;  // acceleration of gravity, base axes
  Vector3 lever;    // foot radius times ground normal, base axes
};

BaseState read_base(EntryReader base) {
  BaseState out;
  out.v = base.vector();
  out.w = base.vector();
  for (int k = 0; k < 3; ++k) out.R.col(k) = base.vector();
  out.gravity = base.vector();
  out.lever = base.vector();
  return out;
}

void add_dynamics(const LegData& data, const Vector3& dq, LegExpressions& out) {
  const auto& body = data.oYcrb[2];
  const Eigen::Matrix<SX, 6, 3> M_base_leg = data.M.topRightCorner<6, 3>();
  append((body.mass() * body.lever()).eval(),
         add_field(out, "MassLever", "mass times centre of mass"));
  append_symmetric(body.matrix().bottomRightCorner<3, 3>(),
                   add_field(out, "Inertia", "rotational inertia about the base's origin"));
  append(M_base_leg * dq, add_field(out, "Momentum", "of the joints' motion alone, linear first"));
  append(data.nle.head<6>(), add_field(out, "HBase", "share of the base's bias"));
  out.summed_count = static_cast<int>(out.results.size());
  append(data.nle.tail<3>(), add_field(out, "HLeg", "bias of the joints"));
  append(M_base_leg, add_field(out, "MBaseLeg", "block of the mass matrix"));
  append_symmetric(data.M.bottomRightCorner<3, 3>(),
                   add_field(out, "MLeg", "block of the mass matrix"));
}

// Add the contact of a spherical foot that rolls on the ground, as in
// PinocchioDynamics::update_leg().
void add_contact(const LegData& data, const BaseState& base, const Vector3& p_calf_foot,
                 LegExpressions& out) {
  const auto& calf = data.oMi[4];
  const Vector3 p_contact = calf.act(p_calf_foot) - base.lever;
  Matrix3 J_leg;
  for (int k = 0; k < 3; ++k) {
    const auto J = data.J.col(6 + k);
    J_leg.col(k) = J.template head<3>() - p_contact.cross(J.template tail<3>());
  }
  const Vector3 w = data.v[4].angular(), alpha = data.a_gf[4].angular();
  const Vector3 v_centre = data.v[4].linear() + w.cross(p_calf_foot);
  const Vector3 a_centre = data.a_gf[4].linear() + alpha.cross(p_calf_foot) + w.cross(v_centre);
  const Vector3 v_contact = calf.rotation() * v_centre + base.lever.cross(calf.rotation() * w);
  const Vector3 drift =
      calf.rotation() * a_centre + base.gravity + base.lever.cross(calf.rotation() * alpha);
  append(base.R * p_contact, add_field(out, "PContact", "from the base's origin, world axes"));
  append(base.R * v_contact, add_field(out, "VContact", "world axes"));
  append(base.R * drift, add_field(out, "Drift", "world axes"));
  append(-base.R * pinocchio::skew(p_contact),
         add_field(out, "JBaseAngular", "contact velocity from w_base, world axes"));
  append(base.R * J_leg, add_field(out, "JLeg", "contact velocity from the joints, world axes"));
  const SX depth = J_leg.col(0).dot(data.J.col(7).template tail<3>());
  add_field(out, "Depth", "foot below the hip axis, but for the sign").push_back(depth);
}

}  // namespace

LegExpressions leg_expressions() {
  LegExpressions out;
  out.parameters = SX::sym("parameters", 3 * 14 + 3);
  out.base = SX::sym("base", 21);
  out.leg = SX::sym("leg", 9);
  Vector3 p_calf_foot;
  LegModel model = leg_model({out.parameters}, p_calf_foot);
  const BaseState base = read_base({out.base});
  model.gravity.linear() = base.gravity;

  VectorX q = VectorX::Zero(model.nq), v(model.nv);
  q[6] = SX(1.0);
  for (int i = 0; i < 6; ++i) q[7 + i] = out.leg(i);
  const Vector3 dq(out.leg(6), out.leg(7), out.leg(8));
  v << base.v, base.w, dq;
  LegData data(model);
  pinocchio::crba(model, data, q, pinocchio::Convention::WORLD);
  pinocchio::nonLinearEffects(model, data, q, v);

  add_dynamics(data, dq, out);
  add_contact(data, base, p_calf_foot, out);
  return out;
}

}  // namespace surefoot::generator
