"""What a log's sensors say of the same tenths of a second, for comparing them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from surefoot.estimate.sensor_log import SensorLog
from surefoot.row_rotations import Array

WINDOW = 0.1  # [s]
TURN = 0.003  # [rad] in a window: 0.03 rad/s, above noise and bias of a gyroscope
ENOUGH = 5  # windows that must tell the same
DEGREES = 180.0 / np.pi


@dataclass(frozen=True)
class Windows:
    """A log's finite rows, cut into windows of about 0.1 s.

    Attributes:
        start: (w,) rows of the log where the windows begin.
        end: (w,) rows where they end, which are where others begin.
        turned: (w, 3) integral of the gyroscope, IMU axes [rad] (if it is in rad/s).
        moved: (w, 12) change of q.
        integrated: (w, 12) integral of dq; zeros if the log has none.
        felt: (w, 3) mean of the accelerometer.
    """

    start: npt.NDArray[np.int64]
    end: npt.NDArray[np.int64]
    turned: Array
    moved: Array
    integrated: Array
    felt: Array

    def __len__(self) -> int:
        return len(self.start)


def cut_windows(log: SensorLog) -> Windows:
    """Cut a log into windows; those much shorter or longer than 0.1 s are left out."""
    names = [name for name in ("gyroscope", "accelerometer", "q", "dq") if name in log.columns]
    good = np.isfinite(log.time)
    for name in names:
        good &= np.isfinite(log.columns[name]).all(axis=1)
    rows = np.flatnonzero(good)
    time = log.time[rows]
    firsts = np.unique(np.floor(time / WINDOW), return_index=True)[1]
    start, end = firsts[:-1], firsts[1:]
    lengths = time[end] - time[start]
    fit = (lengths > 0.5 * WINDOW) & (lengths < 1.5 * WINDOW)
    start, end = start[fit], end[fit]
    step = np.diff(time, prepend=time[:1])[:, None]

    def integral(name: str) -> Array:
        total = np.cumsum(log.sensor(name)[rows] * step, axis=0)
        return np.asarray(total[end] - total[start])

    q, felt = log.columns["q"][rows], np.cumsum(log.columns["accelerometer"][rows], axis=0)
    return Windows(
        start=rows[start],
        end=rows[end],
        turned=integral("gyroscope"),
        moved=q[end] - q[start],
        integrated=integral("dq"),
        felt=(felt[end] - felt[start]) / np.maximum(end - start, 1)[:, None],
    )


def finite_median(values: Array) -> Array:
    """Return the median (k,) of the finite rows of values (n, k); NaN without any."""
    finite = values[np.isfinite(values).all(axis=1)]
    return np.median(finite, axis=0) if len(finite) else np.full(values.shape[1], np.nan)


def unit_rows(values: Array) -> Array:
    """Return the rows (n, k) scaled to length 1; zeros stay."""
    return np.asarray(values / np.maximum(np.linalg.norm(values, axis=1, keepdims=True), 1e-12))


def angles_between(a: Array, b: Array) -> Array:
    """Return the angles (n,) [deg] between rows of unit vectors (n, 3)."""
    return np.asarray(np.degrees(np.arccos(np.clip(np.sum(a * b, axis=1), -1.0, 1.0))))
