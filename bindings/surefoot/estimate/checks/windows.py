"""Sensor data of a log over windows of 0.1 s, so that the checks can compare sensors."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from surefoot.geometry.batch_rotations import Array
from surefoot.sensor_log.sensor_log import SensorLog

# [s] Duration of a window. Chosen: in shorter windows the noise of single samples remains, and in
# longer windows the motion reverses.
WINDOW_TIME = 0.1
# [rad] Smallest rotation of a window that is compared: 0.03 rad/s. Chosen: larger than the default
# bias of a gyroscope (0.02 rad/s; gain start_gyroscope_bias).
MIN_ROTATION = 0.003
# Smallest number of windows for a comparison. Chosen: half a second of motion. With fewer windows,
# one impact may decide.
MIN_WINDOWS = 5
DEG_PER_RAD = 180.0 / np.pi


@dataclass(frozen=True)
class Windows:
    """Motion and sensor data of a log in windows of about 0.1 s, made of its finite rows.

    Attributes:
        start: (w,) rows of the log where the windows begin.
        end: (w,) rows of the log where the windows end.
        gyro_rotation: (w, 3) integral of the gyroscope, IMU axes [rad].
        q_change: (w, 12) change of q [rad].
        dq_integral: (w, 12) integral of dq [rad]; zeros if the log has no dq.
        mean_acceleration: (w, 3) mean of the accelerometer, IMU axes [m/s^2].
    """

    start: npt.NDArray[np.int64]
    end: npt.NDArray[np.int64]
    gyro_rotation: Array
    q_change: Array
    dq_integral: Array
    mean_acceleration: Array

    def __len__(self) -> int:
        return len(self.start)


def cut_windows(log: SensorLog) -> Windows:
    """Cut a log into windows; omit windows shorter than 0.05 s or longer than 0.15 s."""
    names = [name for name in ("gyroscope", "accelerometer", "q", "dq") if name in log.columns]
    good = np.isfinite(log.time)
    for name in names:
        good &= np.isfinite(log.columns[name]).all(axis=1)
    rows = np.flatnonzero(good)
    time = log.time[rows]
    firsts = np.unique(np.floor(time / WINDOW_TIME), return_index=True)[1]
    start, end = firsts[:-1], firsts[1:]
    lengths = time[end] - time[start]
    fit = (lengths > 0.5 * WINDOW_TIME) & (lengths < 1.5 * WINDOW_TIME)
    start, end = start[fit], end[fit]
    step = np.diff(time, prepend=time[:1])[:, None]

    def integral(name: str) -> Array:
        total = np.cumsum(log.sensor(name)[rows] * step, axis=0)
        return np.asarray(total[end] - total[start])

    q, total_acceleration = (
        log.columns["q"][rows],
        np.cumsum(log.columns["accelerometer"][rows], axis=0),
    )
    return Windows(
        start=rows[start],
        end=rows[end],
        gyro_rotation=integral("gyroscope"),
        q_change=q[end] - q[start],
        dq_integral=integral("dq"),
        mean_acceleration=(total_acceleration[end] - total_acceleration[start])
        / np.maximum(end - start, 1)[:, None],
    )


def finite_median(values: Array) -> Array:
    """Return the median (k,) of the finite rows of values (n, k); NaN if no row is finite."""
    finite = values[np.isfinite(values).all(axis=1)]
    return np.median(finite, axis=0) if len(finite) else np.full(values.shape[1], np.nan)


def unit_rows(values: Array) -> Array:
    """Return the rows (n, k) scaled to length 1; rows of zeros stay zero."""
    return np.asarray(values / np.maximum(np.linalg.norm(values, axis=1, keepdims=True), 1e-12))


def angles_between(a: Array, b: Array) -> Array:
    """Return the angles (n,) [deg] between rows of unit vectors (n, 3)."""
    return np.asarray(np.degrees(np.arccos(np.clip(np.sum(a * b, axis=1), -1.0, 1.0))))
