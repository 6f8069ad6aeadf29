"""The estimate row by row, as a file."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from surefoot._core import Status
from surefoot.estimate.estimate_result import Estimate
from surefoot.files.tables import check_table_name, write_table

TRAJECTORY_COLUMNS = {
    "time": "[s] from the log's first row",
    "status": "of the row: surefoot.Status by name; any but OK repeats the last state",
    "p": "base, world [m]",
    "quaternion": "base to world, w x y z",
    "v_world": "base, world axes [m/s]",
    "p_std": "[m]",
    "rotation_std": "about world axes [rad]",
    "v_world_std": "[m/s]",
    "gyroscope_bias": "base axes [rad/s]",
    "gyroscope_bias_std": "[rad/s]",
    "accelerometer_bias": "base axes [m/s^2]",
    "accelerometer_bias_std": "[m/s^2]",
    "contact": "probability of each foot, FR FL RR RL",
    "slip": "how surely each standing foot slips",
}
"""Columns of a trajectory in order; in a CSV those of several numbers are p_0, p_1 ..."""


def trajectory(estimate: Estimate) -> dict[str, np.ndarray]:
    """Return the columns of NAMES, (m,) or (m, k)."""
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
    }
    return {name: columns[name] for name in TRAJECTORY_COLUMNS}


def write_trajectory(path: str | Path, estimate: Estimate) -> None:
    """Write trajectory() as CSV or NPZ by the file's name; raises Error, OSError."""
    write_table(check_table_name(path, "trajectory"), trajectory(estimate))
