"""Errors of estimates against the truth, row by row.

Yaw is not observable. So the estimator's world frame rotates about the vertical, relative to the
true world frame. This rotation is removed in every row first. Errors are estimate minus truth, in
true world axes.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from surefoot.geometry.batch_rotations import (
    matrices_from_xyzw,
    rotation_vectors,
    rotations_about_z,
)

from estimation.log_rows import Array, Log
from estimation.replay import Estimates

GRAVITY = 9.81  # [m/s^2]


@dataclass(frozen=True)
class Errors:
    """Errors of every row.

    Attributes:
        tilt: (n, 2) x and y of the rotation error vector [rad].
        tilt_from_bias: (n, 2) part of the tilt error due to the accelerometer bias [rad]. At rest
            the sensors cannot distinguish this bias from a tilt.
        velocity: (n, 3) velocity of the base [m/s].
        height: (n,) height of the base [m], with a constant offset of the world frames.
        covariance: (n, 5, 5) estimated covariance of tilt and velocity; zeros if it was not kept.
    """

    tilt: Array
    tilt_from_bias: Array
    velocity: Array
    height: Array
    covariance: Array

    @property
    def nees(self) -> Array:
        """(n,) normalised estimation error squared of tilt and velocity; NaN without covariance."""
        error = np.concatenate([self.tilt, self.velocity], axis=1)
        size = np.trace(self.covariance, axis1=1, axis2=2)
        known = size > 0.0
        nees = np.full(len(error), np.nan)
        if known.any():
            solved = np.linalg.solve(self.covariance[known], error[known][:, :, None])
            nees[known] = np.einsum("ni,ni->n", error[known], solved[:, :, 0])
        return nees


def compute_errors(log: Log, estimates: Estimates) -> Errors:
    """Compute the errors of estimates against the truth in their log."""
    R_true = matrices(log["truth_quaternion"])
    R = matrices(estimates.q[:, [6, 3, 4, 5]])
    R_error = R @ np.swapaxes(R_true, 1, 2)
    # Decompose R_error into a rotation about a horizontal axis, followed by this yaw.
    yaw = np.arctan2(R_error[:, 1, 0] - R_error[:, 0, 1], R_error[:, 0, 0] + R_error[:, 1, 1])
    R_yaw_removed = rotations_about_z(-yaw)
    v_world = np.einsum("nij,njk,nk->ni", R_yaw_removed, R, estimates.v[:, :3])
    up = np.einsum("nij,j->ni", R_true, log["truth_accelerometer_bias"]) / GRAVITY
    tilt_and_velocity = [0, 1, 3, 4, 5]
    R_blocks = np.zeros((len(yaw), 5, 5))
    R_blocks[:, :2, :2], R_blocks[:, 2:, 2:] = R_yaw_removed[:, :2, :2], R_yaw_removed
    covariance = np.zeros((len(yaw), 5, 5))
    if len(estimates.covariance):
        covariance = (
            R_blocks
            @ estimates.covariance[:, tilt_and_velocity][:, :, tilt_and_velocity]
            @ np.swapaxes(R_blocks, 1, 2)
        )
    return Errors(
        rotation_vectors(R_yaw_removed @ R_error)[:, :2],
        np.stack([up[:, 1], -up[:, 0]], axis=1),
        v_world - log["truth_v"],
        estimates.q[:, 2] - log["truth_p"][:, 2],
        covariance,
    )


def matrices(quaternions: Array) -> Array:
    """Return the rotation matrices (n, 3, 3) of quaternions (n, 4) w x y z of any length."""
    q = quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)
    return matrices_from_xyzw(q[:, [1, 2, 3, 0]])


def rms(values: Array) -> float:
    """Return the root mean square of all values."""
    return float(np.sqrt(np.mean(np.square(values))))
