"""Kinematics and dynamics of a joint tree, as CasADi expressions.

Source: Featherstone, Rigid Body Dynamics Algorithms, 2008: recursive Newton-Euler algorithm, table
5.1, in body axes. A frame's linear velocity is that of the point at its origin, its linear
acceleration the spatial one.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from surefoot.symbolic.joint_tree import Body, Joint, JointTree

Expression = ca.SX


@dataclass(frozen=True)
class Twist:
    """A velocity, momentum, acceleration or force: linear and angular part (3,), body axes."""

    linear: Expression
    angular: Expression

    def __add__(self, other: Twist) -> Twist:
        return Twist(self.linear + other.linear, self.angular + other.angular)


@dataclass(frozen=True)
class Placement:
    """Rotation (3, 3) and origin (3,) [m] of a frame in another frame."""

    R: Expression
    p: Expression

    def then(self, child: Placement) -> Placement:
        """Return the placement of a child, which is given in this frame, in the other frame."""
        return Placement(self.R @ child.R, self.p + self.R @ child.p)

    def motion_inside(self, motion: Twist) -> Twist:
        """Return a motion of the other frame at this frame's origin and in its axes."""
        return Twist(
            self.R.T @ (motion.linear + ca.cross(motion.angular, self.p)),
            self.R.T @ motion.angular,
        )

    def force_outside(self, force: Twist) -> Twist:
        """Return a force or momentum of this frame at the other frame's origin and in its axes."""
        linear = self.R @ force.linear
        return Twist(linear, self.R @ force.angular + ca.cross(self.p, linear))


class TreeDynamics:
    """Expressions of q, v and a of a joint tree.

    Args:
        tree: The joint tree.

    Attributes:
        tree: The joint tree.
        q: Symbols (nq,), as in Pinocchio: position, quaternion x y z w, joints.
        v: Symbols (nv,): linear and angular velocity of the base in base axes, joints.
        a: Symbols (nv,): time derivative of v.
    """

    def __init__(self, tree: JointTree) -> None:
        self.tree = tree
        self.q = ca.SX.sym("q", tree.nq)
        self.v = ca.SX.sym("v", tree.nv)
        self.a = ca.SX.sym("a", tree.nv)
        self._base = Placement(rotation_of(self.q[3:7]), self.q[:3])
        # Placement of each joint's frame in its parent's frame.
        self._local = [joint_placement(joint, self.q) for joint in tree.joints]

    def inverse_dynamics(self, v: Expression, a: Expression, gravity: bool = True) -> Expression:
        """Return the generalised forces (nv,) [N, N.m] of a motion, armature included."""
        motions = self._velocities(v)
        start = self._base.R.T @ -self.tree.gravity if gravity else ca.SX(3, 1)
        rates = self._accelerations(motions, v, a, start)
        forces = [
            _body_force(body, motion, rate)
            for body, motion, rate in zip(self.tree.bodies, motions, rates, strict=True)
        ]
        tau = ca.SX.zeros(self.tree.nv)
        for i in reversed(range(len(self.tree.joints))):
            joint, force = self.tree.joints[i], forces[i + 1]
            work = ca.dot(joint.linear, force.linear) + ca.dot(joint.angular, force.angular)
            tau[joint.index_v] = work + joint.armature * a[joint.index_v]
            forces[joint.parent + 1] += self._local[i].force_outside(force)
        tau[:3], tau[3:6] = forces[0].linear, forces[0].angular
        return tau

    def foot_positions(self) -> Expression:
        """Return the foot centres (3, 4), world axes [m]."""
        frames = self._world_frames()
        feet = self.tree.feet
        return ca.horzcat(
            *(frames[f.joint + 1].p + frames[f.joint + 1].R @ f.position for f in feet)
        )

    def foot_velocities(self) -> Expression:
        """Return the velocities of the foot centres (3, 4), world axes [m/s]."""
        frames, motions = self._world_frames(), self._velocities(self.v)
        columns = []
        for foot in self.tree.feet:
            motion = motions[foot.joint + 1]
            local = motion.linear + ca.cross(motion.angular, foot.position)
            columns.append(frames[foot.joint + 1].R @ local)
        return ca.horzcat(*columns)

    def foot_drifts(self) -> Expression:
        """Return the accelerations of the foot centres (3, 4) with a = 0, world axes [m/s^2]."""
        frames, motions = self._world_frames(), self._velocities(self.v)
        rates = self._accelerations(motions, self.v, ca.SX(self.tree.nv, 1), ca.SX(3, 1))
        columns = []
        for foot in self.tree.feet:
            motion, rate = motions[foot.joint + 1], rates[foot.joint + 1]
            v = motion.linear + ca.cross(motion.angular, foot.position)
            local = rate.linear + ca.cross(rate.angular, foot.position)
            columns.append(frames[foot.joint + 1].R @ (local + ca.cross(motion.angular, v)))
        return ca.horzcat(*columns)

    def center_of_mass(self) -> Expression:
        """Return the centre of mass (3,), world axes [m]."""
        moment = ca.SX(3, 1)
        for body, frame in zip(self.tree.bodies, self._world_frames(), strict=True):
            moment += body.mass * (frame.p + frame.R @ body.lever)
        return moment / sum(body.mass for body in self.tree.bodies)

    def centroidal_momentum(self) -> Expression:
        """Return linear and angular momentum (6,) about the centre of mass, world axes."""
        total = Twist(ca.SX(3, 1), ca.SX(3, 1))
        frames, motions = self._world_frames(), self._velocities(self.v)
        for body, frame, motion in zip(self.tree.bodies, frames, motions, strict=True):
            total += frame.force_outside(_momentum(body, motion))
        lever = self.center_of_mass()
        return ca.vertcat(total.linear, total.angular - ca.cross(lever, total.linear))

    def tangent_map(self) -> Expression:
        """Return the matrix (nq, nv) that maps v to dq/dt."""
        tangent = ca.SX(self.tree.nq, self.tree.nv)
        x, y, z, w = ca.vertsplit(self.q[3:7])
        tangent[:3, :3] = self._base.R
        tangent[3:7, 3:6] = 0.5 * ca.vertcat(
            ca.horzcat(w, -z, y), ca.horzcat(z, w, -x), ca.horzcat(-y, x, w), ca.horzcat(-x, -y, -z)
        )
        for joint in self.tree.joints:
            if joint.unbounded:
                tangent[joint.index_q, joint.index_v] = -self.q[joint.index_q + 1]
                tangent[joint.index_q + 1, joint.index_v] = self.q[joint.index_q]
            else:
                tangent[joint.index_q, joint.index_v] = 1.0
        return tangent

    def _world_frames(self) -> list[Placement]:
        """Return the placement of the base and of each joint's frame in the world."""
        frames = [self._base]
        for joint, local in zip(self.tree.joints, self._local, strict=True):
            frames.append(frames[joint.parent + 1].then(local))
        return frames

    def _velocities(self, v: Expression) -> list[Twist]:
        """Return the velocity of the base and of each joint's frame."""
        motions = [Twist(v[:3], v[3:6])]
        for joint, local in zip(self.tree.joints, self._local, strict=True):
            own = Twist(joint.linear * v[joint.index_v], joint.angular * v[joint.index_v])
            motions.append(local.motion_inside(motions[joint.parent + 1]) + own)
        return motions

    def _accelerations(
        self, motions: list[Twist], v: Expression, a: Expression, start: Expression
    ) -> list[Twist]:
        """Return the spatial accelerations; `start` (3,) is added to that of the base."""
        rates = [Twist(a[:3] + start, a[3:6])]
        for joint, local, motion in zip(self.tree.joints, self._local, motions[1:], strict=True):
            linear, angular = (part * v[joint.index_v] for part in (joint.linear, joint.angular))
            own = Twist(
                joint.linear * a[joint.index_v]
                + ca.cross(motion.angular, linear)
                + ca.cross(motion.linear, angular),
                joint.angular * a[joint.index_v] + ca.cross(motion.angular, angular),
            )
            rates.append(local.motion_inside(rates[joint.parent + 1]) + own)
        return rates


def rotation_of(quaternion: Expression) -> Expression:
    """Return the rotation matrix (3, 3) of a unit quaternion x y z w."""
    x, y, z, w = ca.vertsplit(quaternion)
    return ca.vertcat(
        ca.horzcat(1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        ca.horzcat(2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        ca.horzcat(2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )


def joint_placement(joint: Joint, q: Expression) -> Placement:
    """Return the placement of a joint's frame in its parent's frame."""
    position = q[joint.index_q]
    if joint.unbounded:
        cosine, sine, shift = position, q[joint.index_q + 1], ca.SX(3, 1)
    else:
        cosine, sine, shift = ca.cos(position), ca.sin(position), joint.linear * position
    # The rotation about a unit axis; the identity if the axis is zero.
    skew = ca.sparsify(ca.skew(joint.angular))
    rotation = ca.SX.eye(3) + sine * skew + (1 - cosine) * (skew @ skew)
    return Placement(joint.R_parent @ rotation, joint.p_parent + joint.R_parent @ shift)


def _momentum(body: Body, motion: Twist) -> Twist:
    """Return the momentum of a body about the origin of its frame; also inertia times any twist."""
    linear = body.mass * (motion.linear + ca.cross(motion.angular, body.lever))
    return Twist(linear, body.inertia @ motion.angular + ca.cross(body.lever, linear))


def _body_force(body: Body, motion: Twist, rate: Twist) -> Twist:
    """Return the force that gives a moving body its acceleration."""
    momentum = _momentum(body, motion)
    gyroscopic = Twist(
        ca.cross(motion.angular, momentum.linear),
        ca.cross(motion.angular, momentum.angular) + ca.cross(motion.linear, momentum.linear),
    )
    return _momentum(body, rate) + gyroscopic
