"""Numbers of a robot's model that its symbolic dynamics need: joints, bodies and feet."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import pinocchio as pin

from surefoot._core import Robot


@dataclass(frozen=True)
class Joint:
    """A joint with one axis, and the body that it moves. Vectors are in axes of the joint's frame.

    Attributes:
        parent: Index of the parent in JointTree.joints; -1: the base.
        R_parent: Rotation (3, 3) from this joint's frame at zero to the parent's frame.
        p_parent: Origin of this joint's frame in the parent's frame (3,) [m].
        angular: Angular velocity (3,) per joint velocity; zero for a prismatic joint.
        linear: Linear velocity (3,) per joint velocity; zero for a revolute joint.
        index_q: Index of the joint's position in q.
        unbounded: Whether q has cosine and sine of the joint's angle instead of the angle.
        index_v: Index of the joint's velocity in v.
        armature: Rotor inertia at the joint [kg.m^2].
        body: The body that the joint moves.
    """

    parent: int
    R_parent: ca.DM
    p_parent: ca.DM
    angular: ca.DM
    linear: ca.DM
    index_q: int
    unbounded: bool
    index_v: int
    armature: float
    body: Body


@dataclass(frozen=True)
class Body:
    """Inertia of a body, in axes of its joint's frame.

    Attributes:
        mass: [kg]
        lever: Centre of mass (3,) [m].
        inertia: Rotational inertia (3, 3) about the centre of mass [kg.m^2].
    """

    mass: float
    lever: ca.DM
    inertia: ca.DM


@dataclass(frozen=True)
class Foot:
    """Centre of a foot.

    Attributes:
        joint: Index in JointTree.joints of the joint that moves the foot.
        position: Centre (3,) in axes of the joint's frame [m].
    """

    joint: int
    position: ca.DM


@dataclass(frozen=True)
class JointTree:
    """A base on a free-flyer joint, and joints with one axis.

    Attributes:
        base: Body of the base.
        joints: All other joints; a parent comes before its children.
        feet: FR FL RR RL.
        gravity: Acceleration of gravity (3,), world axes [m/s^2].
        nq: Size of q.
        nv: Size of v.
    """

    base: Body
    joints: tuple[Joint, ...]
    feet: tuple[Foot, ...]
    gravity: ca.DM
    nq: int
    nv: int

    @property
    def bodies(self) -> tuple[Body, ...]:
        """The base's body, then those of the joints."""
        return (self.base, *(joint.body for joint in self.joints))


def joint_tree(robot: Robot) -> JointTree:
    """Return the joints, bodies and feet of a robot."""
    model = pin.Model()
    model.loadFromString(robot.serialized_model())
    data = model.createData()
    pin.computeJointJacobians(model, data, pin.neutral(model))
    frames = [model.frames[index] for index in robot.foot_frame_ids]
    return JointTree(
        base=_body(model, 1),
        joints=tuple(_joint(model, data, i) for i in range(2, model.njoints)),
        feet=tuple(Foot(f.parentJoint - 2, ca.DM(f.placement.translation)) for f in frames),
        gravity=ca.DM(model.gravity.linear),
        nq=model.nq,
        nv=model.nv,
    )


def _joint(model: pin.Model, data: pin.Data, index: int) -> Joint:
    axis = pin.getJointJacobian(model, data, index, pin.LOCAL)[:, model.idx_vs[index]]
    placement = model.jointPlacements[index]
    return Joint(
        parent=model.parents[index] - 2,
        R_parent=ca.sparsify(ca.DM(placement.rotation)),
        p_parent=ca.DM(placement.translation),
        linear=ca.DM(axis[:3]),
        angular=ca.DM(axis[3:]),
        index_q=model.idx_qs[index],
        unbounded=model.nqs[index] == 2,
        index_v=model.idx_vs[index],
        armature=float(model.armature[model.idx_vs[index]]),
        body=_body(model, index),
    )


def _body(model: pin.Model, index: int) -> Body:
    inertia = model.inertias[index]
    return Body(float(inertia.mass), ca.DM(inertia.lever), ca.DM(inertia.inertia))
