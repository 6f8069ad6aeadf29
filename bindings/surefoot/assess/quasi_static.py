"""The largest push that a robot can lean against for ever: what friction and motors allow."""

from __future__ import annotations

import math

import numpy as np
from scipy.optimize import linprog

from surefoot._core import Error
from surefoot.assess.pinned import Pinned, direction
from surefoot.sim.rotations import Array
from surefoot.sim.support import GRAVITY

EDGES = 16  # of the pyramid inside each friction cone; one of them lies against the push


def quasi_static_force(pinned: Pinned, degrees: float, friction: float) -> float:
    """Return the greatest horizontal force through the centre of mass in equilibrium [N].

    A linear program over the force F and the contact forces of the four feet: forces and moments
    about the centre of mass balance, contact forces are inside their friction cones, and the
    torques |g - J' f| are within what the motors give at rest. Without those limits on motors and
    friction it is m g d / h.

    Args:
        pinned: The robot.
        degrees: Of the force, from forward towards left [deg].
        friction: True coefficient.

    Raises:
        Error: It cannot stand there at all.
    """
    rays = _rays(degrees, friction)  # (3, EDGES)
    balance = np.zeros((6, 1 + 4 * EDGES))
    balance[:3, 0] = direction(degrees)
    torques = np.zeros((12, 1 + 4 * EDGES))
    for leg in range(4):
        columns = slice(1 + leg * EDGES, 1 + (leg + 1) * EDGES)
        balance[:3, columns] = rays
        balance[3:, columns] = np.cross(pinned.contacts[leg] - pinned.com, rays.T).T
        torques[:, columns] = -pinned.jacobians[leg].T @ rays
    weight = np.array([0.0, 0.0, pinned.mass * GRAVITY, 0.0, 0.0, 0.0])
    goal = np.zeros(1 + 4 * EDGES)
    goal[0] = -1.0
    room = np.concatenate(
        [pinned.torque_limit - pinned.gravity_torque, pinned.torque_limit + pinned.gravity_torque]
    )
    found = linprog(goal, A_ub=np.vstack([torques, -torques]), b_ub=room, A_eq=balance, b_eq=weight)
    if not found.success:
        raise Error(
            f"largest quasi-static push at {degrees:g} deg, friction {friction:g}: "
            f"{found.message}; expected a robot whose motors hold its standing pose"
        )
    return float(found.x[0])


def _rays(degrees: float, friction: float) -> Array:
    """Return the edges (3, EDGES) of a pyramid inside the friction cone."""
    angles = math.radians(degrees) + 2.0 * math.pi * np.arange(EDGES) / EDGES
    return np.array([friction * np.cos(angles), friction * np.sin(angles), np.ones(EDGES)])
