"""Finite samples of a log, and their values at other times."""

from __future__ import annotations

import numpy as np

from surefoot.geometry.batch_rotations import Array
from surefoot.sensor_log.sensor_log import SensorLog


def finite_samples(log: SensorLog, *names: str) -> tuple[Array, list[Array]]:
    """Return the times (n,) [s], each once, at which all columns are finite, and the columns."""
    good = np.isfinite(log.time)
    for name in names:
        good &= np.isfinite(log.columns[name]).all(axis=1)
    time, rows = np.unique(log.time[good], return_index=True)
    return time, [log.columns[name][good][rows] for name in names]


def interpolated(time: Array, known: Array, values: Array) -> Array:
    """Return the rows (n, k) at times (n,), from rows (m, k) at the known times (m,)."""
    return np.stack([np.interp(time, known, column) for column in values.T], axis=1)
