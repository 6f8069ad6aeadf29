"""Moving ground under a standing robot: a platform that tilts, or a block that rises.

The platform or block is a body on its own joint, so heavy that the robot does not move it. The
caller sets the velocity of this body. A position set instead would let the surface jump, and a
surface that goes down would leave the feet in the air.
"""

from __future__ import annotations

import math

import mujoco
import numpy as np

from surefoot._core import Robot
from surefoot.messages.low_state_layout import LEGS
from surefoot.sim.settings import PlantSettings

PLATFORM, BLOCK, GROUND_JOINT = "surefoot_platform", "surefoot_block", "surefoot_ground"
# Chosen by hand; tests: test_plant_moving_ground.py.
PLATFORM_HALF_SIZE = (2.0, 2.0, 0.05)  # [m] half sides of the platform: room for a robot that falls
# [m] Half sides of the block. A foot (radius at most 4 cm) that slides would leave a smaller block,
# and other feet would touch a larger block.
BLOCK_HALF_SIZE = (0.06, 0.06, 0.1)
# [m] Initial height of the block's top above the ground, so that the foot touches only the block.
BLOCK_PROTRUSION = 0.001
# Mass of the block [kg], and moment of inertia of the platform [kg.m^2]. The weight of a b1 (550 N)
# changes the block's velocity by 1e-6 m/s in a control period. With larger values the solver loses
# precision (physics/hanging.py).
GROUND_INERTIA = 1e6


def set_ground_speed(model: mujoco.MjModel, data: mujoco.MjData, speed: float) -> None:
    """Set the speed of the moving ground.

    Call this in every control period, because the robot's weight changes the speed.

    Args:
        model: Model of a plant with PlantSettings.platform_heading_deg or block_foot.
        data: State of the model.
        speed: Tilt rate of the platform [rad/s], or upward speed of the block [m/s].
    """
    data.qvel[model.joint(GROUND_JOINT).dofadr[0]] = speed


def add_platform(
    spec: mujoco.MjSpec, heading_deg: float
) -> tuple[mujoco.MjsBody, mujoco.mjtGeom, list[float], list[float]]:
    """Add a platform as ground, and return its body, shape, half sides [m] and position [m].

    The platform tilts about the world origin. The side at heading_deg goes up; the heading is
    measured from forward towards left.
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
    """Add the block if settings.block_foot is set."""
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
    spec.add_exclude(bodyname1="world", bodyname2=BLOCK)  # the block overlaps the ground


def place_block(model: mujoco.MjModel, robot: Robot, settings: PlantSettings) -> None:
    """Place the block below its foot in the standing pose, if settings.block_foot is set."""
    if settings.block_foot is None:
        return
    data = mujoco.MjData(model)
    for name, q in zip(robot.config.joint_names, robot.config.q_standing, strict=True):
        data.qpos[model.joint(name).qposadr[0]] = q
    mujoco.mj_kinematics(model, data)
    foot = robot.config.foot_frames[LEGS.index(settings.block_foot)]
    position = np.append(data.xpos[model.body(foot).id][:2], BLOCK_PROTRUSION - BLOCK_HALF_SIZE[2])
    model.body_pos[model.body(BLOCK).id] = position
