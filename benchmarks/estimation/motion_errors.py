"""Errors of a motion of the base against the truth of its log."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from surefoot.estimate.baselines import BaseMotion
from surefoot.geometry.batch_rotations import rotations_about_z, tilt_between

from estimation.errors import matrices, rms
from estimation.log_rows import Array, Log
from estimation.metrics import Values
from estimation.recording import sample_rate

START_TIME = 1.0  # [s] time from which on the drift counts
WALK_START, WALK_END = 2.5, 1.5  # [s] after the start and before the end: only walking between
RELATIVE_DISTANCE = 2.0  # [m] path over which relative errors are computed
RELATIVE_INTERVAL = 0.2  # [s] time between two starts of such a path
MOVED = 0.05  # [m] path after which the robot walks


def true_motion(log: Log) -> BaseMotion:
    """Return the true motion of a log."""
    return BaseMotion(matrices(log["truth_quaternion"]), log["truth_p"], log["truth_v"])


def motion_values(log: Log, motion: BaseMotion) -> Values:
    """Return velocity RMSE, tilt, end error, height drift, yaw and relative error of a motion.

    Velocities are compared in the axes of the heading. The yaw at START_TIME is taken out.
    """
    truth, walk = true_motion(log), walking_rows(log)
    to_true = rotations_about_z(truth.yaw - motion.yaw)
    velocity = np.einsum("nij,nj->ni", to_true, motion.velocity) - truth.velocity
    in_heading = np.einsum("nji,nj->ni", rotations_about_z(truth.yaw[walk]), velocity[walk])
    end, path = end_error(log, motion), path_length(log)[-1]
    relative = [np.linalg.norm(error[:2]) for _, _, error in relative_errors(log, motion)]
    turned = (motion.yaw - truth.yaw)[[start_row(log), -1]]
    return {
        "velocity RMSE x": rms(in_heading[:, 0]),
        "velocity RMSE y": rms(in_heading[:, 1]),
        "velocity RMSE z": rms(in_heading[:, 2]),
        "tilt RMS": float(np.degrees(rms(tilt_between(truth.rotation, motion.rotation)[walk]))),
        "end error": 100.0 * float(np.linalg.norm(end[:2])) / path,
        "height drift": 100.0 * abs(float(end[2])) / path,
        "yaw error": abs(float(np.degrees(turned[1] - turned[0]))),
        "relative error": 100.0 * float(np.mean(relative)) / RELATIVE_DISTANCE
        if relative
        else np.nan,
    }


def walking_rows(log: Log) -> slice:
    """Return the rows in which the robot walks."""
    rate = sample_rate(log)
    return slice(round(WALK_START * rate), len(log["tick"]) - round(WALK_END * rate))


def start_row(log: Log) -> int:
    """Return the row from which on the drift counts."""
    return round(START_TIME * sample_rate(log))


def path_length(log: Log) -> Array:
    """Return the length of the true path (n,) [m] in the plane up to each row."""
    steps = np.linalg.norm(np.diff(log["truth_p"][:, :2], axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)])


def end_error(log: Log, motion: BaseMotion) -> Array:
    """Return the position error (3,) [m] at the end, aligned in position and yaw at the start."""
    truth, row = true_motion(log), start_row(log)
    return _relative_error(truth, motion, row, len(truth.position) - 1)


def relative_errors(log: Log, motion: BaseMotion) -> Iterator[tuple[int, int, Array]]:
    """Yield start row, end row and position error (3,) [m] of each path of RELATIVE_DISTANCE.

    The motion is aligned with the truth in position and yaw at the start of each path.
    """
    truth, path = true_motion(log), path_length(log)
    for start in range(0, len(path), round(RELATIVE_INTERVAL * sample_rate(log))):
        end = int(np.searchsorted(path, path[start] + RELATIVE_DISTANCE))
        if path[start] >= MOVED and end < len(path):
            yield start, end, _relative_error(truth, motion, start, end)


def _relative_error(truth: BaseMotion, motion: BaseMotion, start: int, end: int) -> Array:
    align = rotations_about_z(truth.yaw[start : start + 1] - motion.yaw[start : start + 1])[0]
    moved = motion.position[end] - motion.position[start]
    return np.asarray(align @ moved - (truth.position[end] - truth.position[start]))
