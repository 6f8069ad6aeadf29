"""Ground that moves under a standing robot: a platform that tilts, a block that rises.

Either is a body on a joint of its own, so heavy that no robot moves it, whose velocity is set:
feet feel a surface that moves, not one that is elsewhere the next instant, which would leave them
in the air on the way down.
"""

from __future__ import annotations

import math

import mujoco
import numpy as np

from surefoot._core import Robot
from surefoot.messages.low_state_layout import LEGS
from surefoot.sim.settings import PlantSettings

PLATFORM, BLOCK, GROUND_JOINT = "surefoot_platform", "surefoot_block", "surefoot_ground"
PLATFORM_HALF_SIZE = (2.0, 2.0, 0.05)  # [m] half sides of the platform
BLOCK_HALF_SIZE = (0.06, 0.06, 0.1)  # [m] half sides of the block
BLOCK_PROTRUSION = (
    0.001  # [m] of the block above the ground at first: its foot stands on nothing else
)
GROUND_INERTIA = 1e6  # [kg], [kg.m^2]


def set_ground_speed(model: mujoco.MjModel, data: mujoco.MjData, speed: float) -> None:
    """Set how fast the ground moves; again in every control period, for robots do weigh.

    Args:
        model: Of a plant with PlantSettings.platform_heading_deg or block_foot.
        data: Its state.
        speed: Of the platform's tilt [rad/s], or of the block upwards [m/s].
    """
    data.qvel[model.joint(GROUND_JOINT).dofadr[0]] = speed


def add_platform(
    spec: mujoco.MjSpec, heading_deg: float
) -> tuple[mujoco.MjsBody, mujoco.mjtGeom, list[float], list[float]]:
    """Add a platform for the ground, and return its body, shape, size and place.

    It tilts about the origin, up towards the heading, from forward towards left [deg].
    """
    angle = math.radians(heading_deg)
    body = spec.worldbody.add_body(name=PLATFORM, gravcomp=1.0)
    axis = [math.sin(angle), -math.cos(angle), 0.0]
    body.add_joint(
        name=GROUND_JOINT, type=mujoco.mjtJoint.mjJNT_HINGE, axis=axis, armature=GROUND_INERTIA
    )
    return (
        body,
        mujoco.mjtGeom.mjGEOM_BOX,
        list(PLATFORM_HALF_SIZE),
        [0.0, 0.0, -PLATFORM_HALF_SIZE[2]],
    )


def add_block(spec: mujoco.MjSpec, settings: PlantSettings) -> None:
    """Add the block, if one is asked for."""
    if settings.block_foot is None:
        return
    body = spec.worldbody.add_body(name=BLOCK, gravcomp=1.0)
    body.add_joint(
        name=GROUND_JOINT,
        type=mujoco.mjtJoint.mjJNT_SLIDE,
        axis=[0.0, 0.0, 1.0],
        armature=GROUND_INERTIA,
    )
    body.add_geom(
        name=BLOCK,
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=BLOCK_HALF_SIZE,
        condim=3,
        rgba=[0.55, 0.6, 0.66, 1.0],
    )
    spec.add_exclude(bodyname1="world", bodyname2=BLOCK)  # it is sunk in the ground


def place_block(model: mujoco.MjModel, robot: Robot, settings: PlantSettings) -> None:
    """Put the block below its foot in the standing pose."""
    if settings.block_foot is None:
        return
    data = mujoco.MjData(model)
    for name, q in zip(robot.config.joint_names, robot.config.q_standing, strict=True):
        data.qpos[model.joint(name).qposadr[0]] = q
    mujoco.mj_kinematics(model, data)
    foot = robot.config.foot_frames[LEGS.index(settings.block_foot)]
    position = np.append(data.xpos[model.body(foot).id][:2], BLOCK_PROTRUSION - BLOCK_HALF_SIZE[2])
    model.body_pos[model.body(BLOCK).id] = position
