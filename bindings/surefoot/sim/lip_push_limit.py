"""LIP push limit: the largest impulse that a linear inverted pendulum survives from rest."""

from __future__ import annotations

import math

import mujoco
import numpy as np

from surefoot.geometry.rotations import Array
from surefoot.sim.model.mujoco_handles import Handles
from surefoot.sim.physics.pushes import heading_vector

GRAVITY = 9.81  # [m/s^2]


def distance_to_edge(points: Array, origin: Array, direction: Array) -> float:
    """Return the length of a ray inside the convex hull of a few points in the plane.

    Args:
        points: (n, 2) points, in any order [m].
        origin: (2,) start of the ray [m].
        direction: (2,) unit vector.

    Returns:
        The length [m]; 0 if the ray starts outside the hull.
    """
    distance = math.inf
    for i, a in enumerate(points):
        for j, b in enumerate(points):
            if i == j:
                continue
            normal = np.array([b[1] - a[1], a[0] - b[0]])
            # a -> b is an edge of the hull, counter-clockwise, if no point is on its right. The
            # tolerance [m^2] covers rounding.
            if np.any((points - a) @ normal > 1e-12):
                continue
            gap, approach = float((a - origin) @ normal), float(direction @ normal)
            if gap < 0.0:
                return 0.0
            if approach > 0.0:
                distance = min(distance, gap / approach)
    return distance


def max_lip_impulse(mass: float, height: float, distance: float, duration: float) -> float:
    """Return the LIP push limit, without steps [N.s].

    J = m w d (w T) / (1 - exp(-w T)), w = sqrt(g / h). A constant force J / T during the time T
    moves the capture point of the pendulum exactly to the support edge, while the centre of
    pressure is at that edge.

    Args:
        mass: Mass m [kg].
        height: Height h of the centre of mass above the ground [m].
        distance: Distance d from the centre of mass to the support edge [m].
        duration: Duration T of the push [s].
    """
    w = math.sqrt(GRAVITY / height)
    return mass * w * distance * (w * duration) / -math.expm1(-w * duration)


def lip_push_limit(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    handles: Handles,
    degrees: float,
    duration: float,
) -> float:
    """Return the LIP push limit of the robot in its present pose, for one direction [N.s].

    The limit uses the true mass with payload, the support polygon of all four feet in the
    horizontal plane, and the height of the centre of mass above the ground.

    Args:
        model: MuJoCo's model.
        data: MuJoCo's state, with kinematics up to date.
        handles: Indices into model and data.
        degrees: Direction from forward towards left [deg].
        duration: Duration of the push [s].
    """
    normal = handles.ground_normal
    ray = heading_vector(data.xmat[handles.root].reshape(3, 3), degrees)
    com = data.subtree_com[handles.root]
    contacts = data.xpos[handles.foot_bodies] - handles.foot_radius * normal
    distance = distance_to_edge(contacts[:, :2], com[:2], ray[:2])
    height = float(com @ normal) / float(normal[2])
    mass = float(model.body_subtreemass[handles.root])
    return max_lip_impulse(mass, height, distance, duration)
