"""Ground that moves under a standing robot: a platform that tilts, a block that rises.

Both move a little at a time between control periods, and their surfaces move along their normals
alone, so a foot is carried by its contact as by ground that stands still, and lags by less than a
millimetre at the speeds here (0.1 m/s times the contact's time constant).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import mujoco
import numpy as np

from surefoot._core import Robot
from surefoot.sim.rotations import slope_quaternion
from surefoot.sim.settings import LEGS, PlantSettings

if TYPE_CHECKING:
    from surefoot.sim.plant import Plant

BLOCK = "surefoot_block"
SIZE = (0.06, 0.06, 0.1)  # [m] half sides
PROUD = 0.001  # [m] above the ground at first, for its foot to stand on nothing else


def tilt_ground(plant: Plant, degrees: float, heading: float) -> None:
    """Tilt the ground about the point below the robot's first place.

    Args:
        plant: Whose reset() leaves the tilt as it is: take it back before.
        degrees: Steepness from now on [deg].
        heading: Direction of steepest ascent, from forward towards left [deg].
    """
    ground = plant.handles.ground_geom
    plant.model.geom_sameframe[ground] = 0  # else MuJoCo takes the world's axes for its own
    plant.model.geom_quat[ground] = slope_quaternion(degrees, heading)


def raise_block(plant: Plant, height: float) -> None:
    """Put the block of PlantSettings.block_foot at a height above the ground [m]."""
    body = plant.model.body(BLOCK)
    plant.data.mocap_pos[body.mocapid[0], 2] = body.pos[2] + height


def add_block(spec: mujoco.MjSpec, settings: PlantSettings) -> None:
    """Add the block, if one is asked for."""
    if settings.block_foot is None:
        return
    body = spec.worldbody.add_body(name=BLOCK, mocap=True)
    body.add_geom(
        name=BLOCK,
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=SIZE,
        condim=3,
        rgba=[0.55, 0.6, 0.66, 1.0],
    )


def place_block(model: mujoco.MjModel, robot: Robot, settings: PlantSettings) -> None:
    """Put the block below its foot in the standing pose."""
    if settings.block_foot is None:
        return
    data = mujoco.MjData(model)
    for name, q in zip(robot.config.joint_names, robot.config.q_standing, strict=True):
        data.qpos[model.joint(name).qposadr[0]] = q
    mujoco.mj_kinematics(model, data)
    foot = robot.config.foot_frames[LEGS.index(settings.block_foot)]
    place = np.append(data.xpos[model.body(foot).id][:2], PROUD - SIZE[2])
    model.body_pos[model.body(BLOCK).id] = place
