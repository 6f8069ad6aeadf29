"""How hard a standing robot can be pushed before no torque saves it: the pendulum's bound."""

from __future__ import annotations

import math

import mujoco
import numpy as np

from surefoot._core import Robot
from surefoot.geometry.rotations import Array
from surefoot.sim.model.mujoco_handles import Handles
from surefoot.sim.physics.pushes import heading_vector

GRAVITY = 9.81  # [m/s^2]


def distance_to_edge(points: Array, origin: Array, direction: Array) -> float:
    """Return how far a ray runs inside the convex hull of a few points in the plane.

    Args:
        points: (n, 2) corners, in any order [m].
        origin: (2,) start of the ray [m].
        direction: (2,) unit vector.

    Returns:
        The distance [m]; 0 if the ray starts outside.
    """
    distance = math.inf
    for i, a in enumerate(points):
        for j, b in enumerate(points):
            if i == j:
                continue
            normal = np.array([b[1] - a[1], a[0] - b[0]])
            # An edge of the hull, walked counter-clockwise, leaves no point on its right.
            if np.any((points - a) @ normal > 1e-12):
                continue
            gap, speed = float((a - origin) @ normal), float(direction @ normal)
            if gap < 0.0:
                return 0.0
            if speed > 0.0:
                distance = min(distance, gap / speed)
    return distance


def max_lip_impulse(mass: float, height: float, distance: float, duration: float) -> float:
    """Return the greatest impulse a robot survives with its feet where they are [N.s].

    J = m w d (w T) / (1 - exp(-w T)), w = sqrt(g / h): a constant force for the time T brings
    the capture point of a linear inverted pendulum to the edge with the pressure kept there.

    Args:
        mass: m [kg].
        height: Of the centre of mass above the ground, h [m].
        distance: From the centre of mass to the edge of support, d [m].
        duration: T [s].
    """
    w = math.sqrt(GRAVITY / height)
    return mass * w * distance * (w * duration) / -math.expm1(-w * duration)


def lip_push_limit(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    handles: Handles,
    robot: Robot,
    degrees: float,
    duration: float,
) -> float:
    """Return max_lip_impulse() of the robot as it stands, towards an angle from forward.

    The true mass with its payload; feet and centre of mass are seen from above, and the height
    is that above the ground below.

    Args:
        model: MuJoCo's model.
        data: MuJoCo's state, its kinematics up to date.
        handles: Indices into both.
        robot: The robot, for its foot radius.
        degrees: Direction from forward towards left [deg].
        duration: Of the push [s].
    """
    normal = handles.ground_normal
    ray = heading_vector(data.xmat[handles.root].reshape(3, 3), degrees)
    com = data.subtree_com[handles.root]
    contacts = data.xpos[handles.foot_bodies] - robot.config.foot_radius * normal
    distance = distance_to_edge(contacts[:, :2], com[:2], ray[:2])
    height = float(com @ normal) / float(normal[2])
    mass = float(model.body_subtreemass[handles.root])
    return max_lip_impulse(mass, height, distance, duration)
