"""Equations of gravity: over whole strides, the accelerometer shows gravity and nothing else.

The mean specific force, without the acceleration of the body, must turn as the gyroscope says. A
tilted body and a slope turn too, so only a bias of a sensor contradicts. Its size must be that of
gravity.
"""

from __future__ import annotations

import numpy as np

from surefoot.estimate.checks.imu import GRAVITY
from surefoot.estimate.checks.walking.identities import (
    ACC_BIAS,
    GAIN,
    GYRO_BIAS,
    PARAMETERS,
    Equations,
    turn_columns,
)
from surefoot.estimate.checks.walking.imu_path import ImuPath
from surefoot.estimate.checks.walking.leg_paths import STEP, LegPaths
from surefoot.estimate.checks.walking.samples import interpolated
from surefoot.estimate.checks.walking.stances import Stances
from surefoot.geometry.batch_rotations import Array, matrices_from_rotation_vectors, products

# [s] Time between the two directions of gravity that are compared, and between the comparisons.
# Chosen: short against the drift of a biased gyroscope, long enough for a turn.
TURN_TIME, INTERVAL = 1.0, 0.1


def gravity_equations(
    paths: LegPaths, stances: Stances, imu: ImuPath
) -> tuple[Equations, Equations]:
    """Return the equations of the direction of gravity, and those of its size."""
    force = _specific_force_at_rest(paths, stances, imu)
    steps = np.diff(imu.rotation, axis=0, prepend=imu.rotation[:1])
    rotation = products(matrices_from_rotation_vectors(steps))
    span, every = round(TURN_TIME / STEP), round(INTERVAL / STEP)
    margin = round(0.5 * stances.stride / STEP)
    first = np.arange(margin, len(force) - span - margin, every)
    last = first + span
    back = np.swapaxes(rotation[last], 1, 2) @ rotation[first]  # from axes at first to last
    seen = np.einsum("nij,nj->ni", back, force[first])
    theta = imu.rotation[last] - imu.rotation[first]
    half = np.swapaxes(rotation[last], 1, 2) @ rotation[(first + last) // 2]
    turn = turn_columns(seen) @ half  # of axes in the middle of the time
    C = np.zeros((len(first), 3, PARAMETERS))
    C[:, :, GAIN] = turn * theta[:, None]
    C[:, :, GYRO_BIAS] = -TURN_TIME * turn
    C[:, :, ACC_BIAS] = back - np.eye(3)
    count = round(len(first) * INTERVAL / TURN_TIME)
    return Equations(force[last] - seen, C, count), _size_equations(force[margin:-margin:every])


def _size_equations(force: Array) -> Equations:
    size = np.linalg.norm(force, axis=1, keepdims=True)
    C = np.zeros((len(force), 1, PARAMETERS))
    C[:, 0, ACC_BIAS] = -force / np.maximum(size, 1e-9)
    return Equations(size - GRAVITY, C, round(len(force) * INTERVAL / TURN_TIME))


def _specific_force_at_rest(paths: LegPaths, stances: Stances, imu: ImuPath) -> Array:
    """Return the mean specific force over a stride minus the acceleration of the IMU (n, 3).

    The velocity of the IMU is that of the stance feet; its vertical part is assumed to be 0.
    """
    place = np.arange(4)
    path, arm = paths.path[:, place, place], paths.arm[:, place, place]
    omega = np.gradient(imu.rotation, STEP, axis=0)
    slide = np.gradient(path, STEP, axis=0) + np.cross(omega[:, None], arm)
    weight = stances.middle.astype(float)[:, :, None]
    total = weight.sum(axis=1)[:, 0]
    mean = -np.sum(weight * slide, axis=1) / np.maximum(total, 1.0)[:, None]
    rows, known = np.arange(len(mean)), np.flatnonzero(total > 0)
    if len(known) == 0:
        return imu.mean_force
    velocity = interpolated(rows.astype(float), known.astype(float), mean[known])
    velocity[:, 2] = 0.0
    half = max(1, round(0.5 * stances.stride / STEP))
    early, late = np.maximum(rows - half, 0), np.minimum(rows + half, len(rows) - 1)
    change = (velocity[late] - velocity[early]) / (np.maximum(late - early, 1) * STEP)[:, None]
    turn = _running_mean(np.cross(omega, velocity), half)
    return _running_mean(imu.mean_force - change - turn, half)


def _running_mean(values: Array, half: int) -> Array:
    """Return the means (n, 3) of the rows from `half` before to `half` after."""
    total = np.concatenate([np.zeros((1, 3)), np.cumsum(values, axis=0)])
    rows = np.arange(len(values))
    low, high = np.maximum(rows - half, 0), np.minimum(rows + half + 1, len(values))
    return np.asarray((total[high] - total[low]) / (high - low)[:, None])
