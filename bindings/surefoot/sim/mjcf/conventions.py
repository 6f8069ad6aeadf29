"""Sign and zero of the joints of two quadrupeds, compared by the directions of axes and links.

The convention of the controller's robot is kept: a joint of the file with the opposite sign or
another zero is converted when the model is built (sim/mjcf/adapt.py).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np

from surefoot._core import Error, Robot
from surefoot.geometry.rotations import Array
from surefoot.messages.low_state_layout import LEGS
from surefoot.sim.mjcf.feet import Foot
from surefoot.sim.mjcf.names import joint_name
from surefoot.sim.mjcf.tree import Tree

# [rad] Difference of zeros that counts as another shape of the links, not as another convention.
# Chosen: ten times the difference of the known files of one robot (a foot 2 mm behind its calf).
ZERO_TOLERANCE = 0.1
# Cosine of the largest angle between an axis and its expected direction. Chosen: 20 degrees; no
# known robot has skew hips.
_MIN_ALIGNMENT = math.cos(math.radians(20.0))


@dataclass(frozen=True)
class LegGeometry:
    """A leg in some pose, as axes and points in the base frame.

    Attributes:
        axes: (3, 3) directions of the axes of hip, thigh and calf, one per row.
        hip: (3,) any point of the axis of the hip joint [m].
        thigh: (3,) point of the thigh joint [m].
        calf: (3,) point of the calf joint [m].
        foot: (3,) centre of the foot [m].
    """

    axes: Array
    hip: Array
    thigh: Array
    calf: Array
    foot: Array

    @property
    def hip_point(self) -> Array:
        """Point of the hip's axis that is nearest to the thigh joint (3,) [m].

        It does not depend on the pose, nor on where a file puts the joint on its axis.
        """
        axis = self.axes[0]
        return np.asarray(self.hip + axis * float(axis @ (self.thigh - self.hip)))

    @property
    def lengths(self) -> tuple[float, float]:
        """Lengths of thigh and calf, seen along the axis of the calf joint [m]."""
        axis = self.axes[2]
        upper = np.linalg.norm(np.cross(self.calf - self.thigh, axis))
        return float(upper), float(np.linalg.norm(np.cross(self.foot - self.calf, axis)))


@dataclass(frozen=True)
class JointConvention:
    """How a joint coordinate of the file becomes one of the controller's robot.

    Attributes:
        sign: 1.0, or -1.0 if the axis points the other way.
        reference: Coordinate of the controller's robot in the file's initial pose [rad].
        converted: Whether sign or zero differ from those of the file.
    """

    sign: float
    reference: float
    converted: bool


def leg_angles(leg: LegGeometry) -> tuple[Array, Array, Array]:
    """Return the pose of a leg, for a hip that turns about base x, and thigh and calf about hip y.

    Returns:
        Signs (3,) of the axes; angles (3,) [rad] from a leg that hangs straight down; cosines (3,)
        of the angles between the axes and their expected directions.
    """
    signs = np.ones(3)
    hip, thigh, calf = leg.axes
    signs[0] = math.copysign(1.0, hip[0])
    roll = math.atan2(thigh[2], thigh[1])
    if abs(roll) > math.pi / 2:
        signs[1], roll = -1.0, math.atan2(-thigh[2], -thigh[1])
    y = np.array([0.0, math.cos(roll), math.sin(roll)])
    signs[2] = math.copysign(1.0, float(calf @ y))
    alignment = np.array([abs(hip[0]), abs(float(thigh @ y)), abs(float(calf @ y))])
    down = np.cross([1.0, 0.0, 0.0], -y)  # the z axis of the hip, downwards
    pitches = [
        math.atan2(-float(link[0]), float(link @ down))
        for link in (leg.calf - leg.thigh, leg.foot - leg.calf)
    ]
    angles = np.array([roll, pitches[0], _wrapped(pitches[1] - pitches[0])])
    return signs, angles, alignment


def mjcf_legs(model: mujoco.MjModel, tree: Tree, feet: tuple[Foot, ...]) -> list[LegGeometry]:
    """Return the legs FR FL RR RL of a compiled model in the file's initial pose."""
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    origin, rotation = data.xpos[tree.base], data.xmat[tree.base].reshape(3, 3)
    legs = []
    for joints, foot in zip(tree.legs, feet, strict=True):
        foot_point = data.xpos[foot.body] + data.xmat[foot.body].reshape(3, 3) @ foot.centre
        points = [*data.xanchor[list(joints)], foot_point]
        hip, thigh, calf, end = ((point - origin) @ rotation for point in points)
        legs.append(LegGeometry(data.xaxis[list(joints)] @ rotation, hip, thigh, calf, end))
    return legs


def robot_legs(robot: Robot) -> list[LegGeometry]:
    """Return the legs FR FL RR RL of the controller's robot, with all joints at zero."""
    import pinocchio

    model = pinocchio.Model()
    model.loadFromString(robot.serialized_model())
    data: Any = model.createData()
    q = pinocchio.neutral(model)
    pinocchio.computeJointJacobians(model, data, q)
    pinocchio.updateFramePlacements(model, data)
    legs = []
    for leg, frame in enumerate(robot.foot_frame_ids):
        ids = [model.getJointId(name) for name in robot.config.joint_names[3 * leg :][:3]]
        axes = np.array([data.J[3:, robot.motor_to_v[3 * leg + k]] for k in range(3)])
        hip, thigh, calf = (data.oMi[joint].translation.copy() for joint in ids)
        legs.append(LegGeometry(axes, hip, thigh, calf, data.oMf[frame].translation.copy()))
    return legs


def joint_conventions(
    model: mujoco.MjModel, tree: Tree, feet: tuple[Foot, ...], robot: Robot
) -> list[JointConvention]:
    """Return the conventions of the twelve joints, SDK order.

    Raises:
        Error: An axis of the file is not that of a hip, thigh or calf; the message names the joint.
    """
    conventions = []
    ours = robot_legs(robot)
    for leg, (geometry, joints) in enumerate(
        zip(mjcf_legs(model, tree, feet), tree.legs, strict=True)
    ):
        signs, angles, alignment = leg_angles(geometry)
        if alignment.min() < _MIN_ALIGNMENT:
            raise _axis_error(model, geometry, joints, leg, int(alignment.argmin()))
        robot_signs, robot_zeros, _ = leg_angles(ours[leg])
        for k, joint in enumerate(joints):
            sign = float(signs[k] * robot_signs[k])
            file_reference = float(model.qpos0[model.jnt_qposadr[joint]])
            reference = float(robot_signs[k]) * _wrapped(float(angles[k] - robot_zeros[k]))
            moved = abs(_wrapped(reference - sign * file_reference)) > ZERO_TOLERANCE
            if not moved:
                reference = sign * file_reference
            conventions.append(JointConvention(sign, reference, moved or sign < 0.0))
    return conventions


def _axis_error(
    model: mujoco.MjModel, leg: LegGeometry, joints: tuple[int, int, int], number: int, k: int
) -> Error:
    axis = " ".join(f"{a:.3f}" for a in leg.axes[k])
    part, expected = ("hip", "thigh", "calf")[k], ("base x", "base y", "that of the thigh")[k]
    return Error(
        f"joint '{joint_name(model, joints[k])}': got axis {axis} in the base frame for the {part} "
        f"of leg {LEGS[number]}, expected {expected}, either sign; the order in a leg must be hip, "
        "thigh, calf, and the base's x axis must point forward"
    )


def _wrapped(angle: float) -> float:
    """Return an angle [rad] in -pi .. pi."""
    return math.remainder(angle, 2.0 * math.pi)
