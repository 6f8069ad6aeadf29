"""Figures of great biases that are to be found."""

from __future__ import annotations

import math

import numpy as np
from surefoot import Robot

from estimation.cases import STILL
from estimation.errors import matrices
from estimation.figures import Result, Values
from estimation.log_rows import Log
from estimation.replay import Estimates, replay
from estimation.rows import rows_of


def bias(robot: Robot, logs: dict[str, Log], seed: int) -> Result:
    """Errors of biases after ten still seconds, and of the horizontal one after motions."""
    log = logs["bias"]
    estimates = replay(robot, log, keep_covariance=True)
    still = min(rows_of(log, STILL), len(log["tick"])) - 1
    values: Values = {"fell": float(log["fell"])}
    if np.any(estimates.gyro_bias) or np.any(estimates.accelerometer_bias):
        values.update(_bias_errors(log, estimates, still))
    else:
        names = ("gyro bias error", "vertical bias error", "horizontal bias sigma, still")
        values.update(dict.fromkeys((*names, "horizontal bias error, moved"), math.nan))
    values.update(_reached(log, still))
    return Result(values)


def _bias_errors(log: Log, estimates: Estimates, still: int) -> Values:
    gyro = estimates.gyro_bias[still] - log["truth_gyro_bias"]
    accelerometer = estimates.accelerometer_bias - log["truth_accelerometer_bias"]
    variance = estimates.covariance[still, [12, 13], [12, 13]]
    return {
        "gyro bias error": float(np.abs(gyro).max()),
        "vertical bias error": float(abs(accelerometer[still, 2])),
        "horizontal bias sigma, still": float(np.sqrt(variance.min())),
        "horizontal bias error, moved": float(np.abs(accelerometer[-1, :2]).max()),
    }


def _reached(log: Log, still: int) -> Values:
    """Return how far the body got in each direction, the lesser of the two [deg]."""
    R = matrices(log["truth_quaternion"])
    turn = np.swapaxes(R[still : still + 1], 1, 2) @ R[still:]
    angles = {
        "roll": np.arctan2(turn[:, 2, 1], turn[:, 2, 2]),
        "pitch": -np.arcsin(np.clip(turn[:, 2, 0], -1.0, 1.0)),
        "yaw": np.arctan2(turn[:, 1, 0], turn[:, 0, 0]),
    }
    return {
        f"reached: {axis}": math.degrees(min(float(angle.max()), float(-angle.min())))
        for axis, angle in angles.items()
    }
