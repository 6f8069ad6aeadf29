"""Table of an estimate, one line per row, as a file."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from surefoot._core import Status
from surefoot.estimate.estimate_result import Estimate
from surefoot.files.tables import check_table_name, write_table

TRAJECTORY_COLUMNS = {
    "time": "[s] since the first row of the log",
    "status": "name of surefoot.Status; rows other than OK repeat the last state",
    "p": "position of the base, world [m]",
    "quaternion": "w x y z, base to world",
    "v_world": "velocity of the base, world axes [m/s]",
    "p_std": "standard deviation of p [m]",
    "rotation_std": "standard deviation of the rotation about world axes [rad]",
    "v_world_std": "standard deviation of v_world [m/s]",
    "gyroscope_bias": "base axes [rad/s]",
    "gyroscope_bias_std": "standard deviation of gyroscope_bias [rad/s]",
    "accelerometer_bias": "base axes [m/s^2]",
    "accelerometer_bias_std": "standard deviation of accelerometer_bias [m/s^2]",
    "contact": "contact confidence of each foot, FR FL RR RL",
    "slip": "confidence that each loaded foot slips, 0 .. 1",
    "friction": "learnt friction coefficient of the ground",
}
"""Columns of a trajectory in order; in a CSV, the components of a vector p are p_0, p_1 ..."""


def trajectory(estimate: Estimate) -> dict[str, np.ndarray]:
    """Return the columns of TRAJECTORY_COLUMNS by name, each (m,) or (m, k)."""
    std = estimate.std
    names = {status.value: status.name for status in Status}
    columns = {
        "time": estimate.time,
        "status": np.array([names[value] for value in estimate.status.tolist()]),
        "p": estimate.q[:, :3],
        "quaternion": estimate.q[:, [6, 3, 4, 5]],
        "v_world": estimate.v_world,
        "p_std": std[:, 6:9],
        "rotation_std": std[:, :3],
        "v_world_std": std[:, 3:6],
        "gyroscope_bias": estimate.gyroscope_bias,
        "gyroscope_bias_std": std[:, 9:12],
        "accelerometer_bias": estimate.accelerometer_bias,
        "accelerometer_bias_std": std[:, 12:15],
        "contact": estimate.contact,
        "slip": estimate.slip,
        "friction": estimate.friction,
    }
    return {name: columns[name] for name in TRAJECTORY_COLUMNS}


def write_trajectory(path: str | Path, estimate: Estimate) -> None:
    """Write the result of trajectory() as CSV or NPZ, depending on the suffix of `path`.

    Raises:
        Error: The suffix is neither .csv nor .npz.
        OSError: The file cannot be written.
    """
    write_table(check_table_name(path, "trajectory"), trajectory(estimate))
