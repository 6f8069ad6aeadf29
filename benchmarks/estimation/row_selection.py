"""Selection of rows of a log by time or push."""

from __future__ import annotations

import numpy as np

from estimation.log_rows import Array, Log
from estimation.recording import sample_rate

SETTLING_TIME = 1.0  # [s] time after the start of a log from which the estimator is evaluated


def rows_after(log: Log, start: float) -> slice:
    """Return the rows after a time [s]."""
    return slice(round(start * sample_rate(log)), None)


def row_at(log: Log, time: float) -> int:
    """Return the row of a time [s]."""
    return round(time * sample_rate(log))


def push_rows(log: Log) -> list[int]:
    """Return the rows in which pushes start, except for pushes in the last 0.5 s."""
    rows = [row_at(log, float(time)) for time in log["push_times"]]
    return [row for row in rows if row < len(log["tick"]) - row_at(log, 0.5)]


def true_speed(log: Log) -> Array:
    """Return the true speed (n,) of the base [m/s]."""
    return np.asarray(np.linalg.norm(log["truth_v"], axis=1))
