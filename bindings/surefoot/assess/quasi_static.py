"""Quasi-static push: the largest constant force that friction and motors can balance."""

from __future__ import annotations

import math

import numpy as np
from scipy.optimize import linprog

from surefoot._core import Error
from surefoot.assess.stance_model import StanceModel, direction_vector
from surefoot.geometry.rotations import Array
from surefoot.sim.lip_push_limit import GRAVITY

# Number of edges of the pyramid that replaces a friction cone; one edge points along the push.
# Chosen: along the push the pyramid is as wide as the cone, elsewhere narrower by at most
# 1 - cos(pi / 16) = 1.9 %.
CONE_EDGES = 16


def quasi_static_force(stance: StanceModel, direction_deg: float, friction: float) -> float:
    """Compute the largest horizontal force at the centre of mass that allows equilibrium [N].

    The function maximises this force F by linear programming; the other variables are the contact
    forces f of the four feet. The constraints are: forces and moments about the centre of mass
    balance, f is inside the friction cones, and the joint torques tau_g - J' f are within the
    motor limits at rest. The torques tau_g hold the weight of the legs. Without the limits of
    friction and torque the result would be m g d / h, with the mass m, d = stance.edge_distance()
    and the height h of the centre of mass.

    Args:
        stance: Model of the standing robot.
        direction_deg: Direction of the force, from forward towards left [deg].
        friction: True friction coefficient.

    Raises:
        Error: No contact forces hold the robot in its standing pose.
    """
    rays = _rays(direction_deg, friction)  # (3, CONE_EDGES)
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
    """Return the edges (3, CONE_EDGES) of a pyramid inside the friction cone, with z = 1."""
    angles = math.radians(direction_deg) + 2.0 * math.pi * np.arange(CONE_EDGES) / CONE_EDGES
    return np.array([friction * np.cos(angles), friction * np.sin(angles), np.ones(CONE_EDGES)])
