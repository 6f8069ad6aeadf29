"""The largest push that a robot can lean against for ever: what friction and motors allow."""

from __future__ import annotations

import math

import numpy as np
from scipy.optimize import linprog

from surefoot._core import Error
from surefoot.assess.stance_model import StanceModel, direction_vector
from surefoot.geometry.rotations import Array
from surefoot.sim.lip_push_limit import GRAVITY

CONE_EDGES = 16  # of the pyramid inside each friction cone; one of them lies against the push


def quasi_static_force(stance: StanceModel, direction_deg: float, friction: float) -> float:
    """Return the greatest horizontal force through the centre of mass in equilibrium [N].

    A linear program over the force F and the contact forces of the four feet: forces and moments
    about the centre of mass balance, contact forces are inside their friction cones, and the
    torques |g - J' f| are within what the motors give at rest. Without those limits on motors and
    friction it is m g d / h.

    Args:
        stance: The robot.
        direction_deg: Of the force, from forward towards left [deg].
        friction: True coefficient.

    Raises:
        Error: It cannot stand there at all.
    """
    rays = _rays(direction_deg, friction)  # (3, EDGES)
    wrench_matrix = np.zeros((6, 1 + 4 * CONE_EDGES))
    wrench_matrix[:3, 0] = direction_vector(direction_deg)
    torques = np.zeros((12, 1 + 4 * CONE_EDGES))
    for leg in range(4):
        columns = slice(1 + leg * CONE_EDGES, 1 + (leg + 1) * CONE_EDGES)
        wrench_matrix[:3, columns] = rays
        wrench_matrix[3:, columns] = np.cross(stance.contacts[leg] - stance.com, rays.T).T
        torques[:, columns] = -stance.jacobians[leg].T @ rays
    weight = np.array([0.0, 0.0, stance.mass * GRAVITY, 0.0, 0.0, 0.0])
    cost = np.zeros(1 + 4 * CONE_EDGES)
    cost[0] = -1.0
    torque_margin = np.concatenate(
        [stance.torque_limit - stance.gravity_torque, stance.torque_limit + stance.gravity_torque]
    )
    solution = linprog(
        cost,
        A_ub=np.vstack([torques, -torques]),
        b_ub=torque_margin,
        A_eq=wrench_matrix,
        b_eq=weight,
    )
    if not solution.success:
        raise Error(
            f"largest quasi-static push at {direction_deg:g} deg, friction {friction:g}: "
            f"{solution.message}; expected a robot whose motors hold its standing pose"
        )
    return float(solution.x[0])


def _rays(direction_deg: float, friction: float) -> Array:
    """Return the edges (3, EDGES) of a pyramid inside the friction cone."""
    angles = math.radians(direction_deg) + 2.0 * math.pi * np.arange(CONE_EDGES) / CONE_EDGES
    return np.array([friction * np.cos(angles), friction * np.sin(angles), np.ones(CONE_EDGES)])
