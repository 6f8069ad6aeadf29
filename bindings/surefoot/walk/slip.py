"""Slip of spherical feet: the motion of the point that touches the ground."""

from __future__ import annotations

import mujoco
import numpy as np

from surefoot.geometry.rotations import Array
from surefoot.sim import Plant


def slip_velocities(plant: Plant) -> Array:
    """Return the velocity (3, 4) of each foot's contact point in world axes [m/s].

    The contact point is the material point of the foot sphere that is nearest to the ground. A foot
    that rolls moves its centre, but not this point. For a loaded foot the point is where MuJoCo
    applies friction: half of the penetration above the lowest point. The ground must not move. On a
    terrain, a foot at an edge counts as one on the surface below its centre.

    Args:
        plant: The plant; its ground goes through the origin.
    """
    handles, radius = plant.handles, plant.handles.foot_radius
    normal = handles.ground_normal
    motion, motions = np.zeros(6), np.zeros((4, 6))
    for leg, body in enumerate(handles.foot_bodies):
        mujoco.mj_objectVelocity(
            plant.model, plant.data, mujoco.mjtObj.mjOBJ_XBODY, body, motion, 0
        )
        motions[leg] = motion
    feet = plant.data.xpos[handles.foot_bodies]
    heights = feet @ normal - plant.settings.terrain.heights_at(feet[:, :2])
    penetration = np.maximum(0.0, radius - heights)
    arms = -(radius - 0.5 * penetration)[:, None] * normal
    return np.asarray((motions[:, 3:] + np.cross(motions[:, :3], arms)).T)
