"""Report on a robot: masses, legs, feet, and values that are possible but unusual."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from surefoot._core import Robot
from surefoot.messages.low_state_layout import LEGS
from surefoot.robot.description import RobotDescription
from surefoot.robot.loading import build_robot
from surefoot.robot.urdf import read_urdf


@dataclass(frozen=True)
class BodyRow:
    """A moving body: its first link, its joint, and its mass [kg] with all links fixed to it."""

    link: str
    joint: str
    mass: float


@dataclass(frozen=True)
class LegRow:
    """A leg: name, foot frame, lengths [m], foot (x, y, z) [m] in the standing pose, base axes."""

    leg: str
    frame: str
    thigh: float
    calf: float
    foot: tuple[float, float, float]


@dataclass(frozen=True)
class RobotReport:
    """Result of check_robot().

    Attributes:
        robot: The robot.
        bodies: All moving bodies, the base first.
        legs: FR FL RR RL.
        doubts: Values that are possible but unusual, one sentence each.
    """

    robot: Robot
    bodies: tuple[BodyRow, ...]
    legs: tuple[LegRow, ...]
    doubts: tuple[str, ...]


def check_robot(description: RobotDescription) -> RobotReport:
    """Load a robot and describe it.

    Raises:
        Error: The robot cannot be loaded, see load_robot().
    """
    import pinocchio

    robot = build_robot(description)
    model = pinocchio.Model()
    model.loadFromString(robot.serialized_model())
    data = model.createData()
    pinocchio.computeJointJacobians(model, data, robot.q_standing())
    pinocchio.updateFramePlacements(model, data)
    names: dict[int, str] = {}
    for frame in model.frames:
        if frame.type == pinocchio.FrameType.BODY:
            names.setdefault(frame.parentJoint, frame.name)
    bodies = [
        BodyRow(names.get(joint, ""), model.names[joint], float(model.inertias[joint].mass))
        for joint in range(1, model.njoints)
    ]
    legs = []
    for leg, frame in enumerate(robot.foot_frame_ids):
        foot = data.oMf[frame].translation
        joints = [model.getJointId(name) for name in robot.config.joint_names[3 * leg :][:3]]
        _, thigh, calf = (data.oMi[joint].translation for joint in joints)
        axis = data.J[3:, robot.motor_to_v[3 * leg + 2]]
        upper, lower = (float(np.linalg.norm(np.cross(p - calf, axis))) for p in (thigh, foot))
        x, y, z = map(float, foot)
        legs.append(LegRow(LEGS[leg], model.frames[frame].name, upper, lower, (x, y, z)))
    doubts = (*read_urdf(description.urdf, description.table).doubts, *robot.doubts)
    return RobotReport(robot, tuple(bodies), tuple(legs), doubts)
