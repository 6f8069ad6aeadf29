"""Case bias: figures of the estimates of large IMU biases."""

from __future__ import annotations

import math

import numpy as np
from surefoot import Robot

from estimation.errors import matrices
from estimation.log_rows import Log
from estimation.metrics import Result, Values
from estimation.replay import Estimates, replay
from estimation.row_selection import row_at
from estimation.scenarios import STILL_TIME


def bias(robot: Robot, logs: dict[str, Log], seed: int) -> Result:
    """Evaluate the bias errors after ten seconds at rest, and the horizontal ones after motion."""
    log = logs["bias"]
    estimates = replay(robot, log, keep_covariance=True)
    last_still_row = min(row_at(log, STILL_TIME), len(log["tick"])) - 1
    values: Values = {"fell": float(log["fell"])}
    if np.any(estimates.gyro_bias) or np.any(estimates.accelerometer_bias):
        values.update(_bias_errors(log, estimates, last_still_row))
    else:
        names = ("gyro bias error", "vertical bias error", "horizontal bias sigma, still")
        values.update(dict.fromkeys((*names, "horizontal bias error, moved"), math.nan))
    values.update(_reached_angles(log, last_still_row))
    return Result(values)


def _bias_errors(log: Log, estimates: Estimates, last_still_row: int) -> Values:
    gyro = estimates.gyro_bias[last_still_row] - log["truth_gyro_bias"]
    accelerometer = estimates.accelerometer_bias - log["truth_accelerometer_bias"]
    variance = estimates.covariance[last_still_row, [12, 13], [12, 13]]
    return {
        "gyro bias error": float(np.abs(gyro).max()),
        "vertical bias error": float(abs(accelerometer[last_still_row, 2])),
        "horizontal bias sigma, still": float(np.sqrt(variance.min())),
        "horizontal bias error, moved": float(np.abs(accelerometer[-1, :2]).max()),
    }


def _reached_angles(log: Log, last_still_row: int) -> Values:
    """Return the angle [deg] that the body reached about each axis in both directions."""
    R = matrices(log["truth_quaternion"])
    turn = np.swapaxes(R[last_still_row : last_still_row + 1], 1, 2) @ R[last_still_row:]
    angles = {
        "roll": np.arctan2(turn[:, 2, 1], turn[:, 2, 2]),
        "pitch": -np.arcsin(np.clip(turn[:, 2, 0], -1.0, 1.0)),
        "yaw": np.arctan2(turn[:, 1, 0], turn[:, 0, 0]),
    }
    return {
        f"reached: {axis}": math.degrees(min(float(angle.max()), float(-angle.min())))
        for axis, angle in angles.items()
    }
