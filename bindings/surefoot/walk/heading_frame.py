"""Velocity and attitude of the body relative to heading and ground."""

from __future__ import annotations

import numpy as np

from surefoot.geometry.batch_rotations import matrices_from_xyzw, rpy_from_matrices
from surefoot.geometry.rotations import matrix_from_wxyz
from surefoot.stand.simulation_log import Array
from surefoot.walk.walk_log import WalkLog
from surefoot.walk.walk_motion import WalkMotion


def attitude_on_ground(log: WalkMotion) -> Array:
    """Return the true roll, pitch, yaw (n, 3) [rad] of the base relative to the ground plane.

    On level ground these are the usual angles. The yaw has no jumps of 2 pi.
    """
    ground = _shortest_rotation(log.ground_normal)
    rpy = rpy_from_matrices(ground.T @ matrices_from_xyzw(log.q_true[:, 3:7]))
    rpy[:, 2] = np.unwrap(rpy[:, 2])
    return rpy


def heading_velocity(log: WalkMotion) -> Array:
    """Return the true velocity (n, 3): vx, vy [m/s] of the centre of mass, yaw rate [rad/s].

    The velocity is horizontal, along and to the left of the heading, as a WalkVelocity. The yaw
    rate is the rate about world z.
    """
    yaw = attitude_on_ground(log)[:, 2]
    c, s = np.cos(yaw), np.sin(yaw)
    vx, vy = log.com_velocity[:, 0], log.com_velocity[:, 1]
    rotation = matrices_from_xyzw(log.q_true[:, 3:7])
    yaw_rate = np.einsum("nj,nj->n", rotation[:, 2, :], log.v_true[:, 3:6])
    return np.stack([c * vx + s * vy, c * vy - s * vx, yaw_rate], axis=1)


def commanded_path(log: WalkLog) -> Array:
    """Return the pose (n, 3) that follows the command exactly: x, y [m], heading [rad].

    The path begins at the true centre of mass and heading of the first tick.
    """
    step = log.commanded / log.rate
    yaw = attitude_on_ground(log)[0, 2] + np.cumsum(step[:, 2]) - step[:, 2]
    c, s = np.cos(yaw), np.sin(yaw)
    dx, dy = c * step[:, 0] - s * step[:, 1], s * step[:, 0] + c * step[:, 1]
    x, y = log.com[0, 0] + np.cumsum(dx) - dx, log.com[0, 1] + np.cumsum(dy) - dy
    return np.stack([x, y, yaw], axis=1)


def _shortest_rotation(normal: Array) -> Array:
    """Return the shortest rotation (3, 3) of the vertical to a unit normal."""
    wxyz = np.array([1.0 + normal[2], -normal[1], normal[0], 0.0])
    return matrix_from_wxyz(wxyz / np.linalg.norm(wxyz))
