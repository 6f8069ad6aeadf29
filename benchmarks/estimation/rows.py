"""Rows of a log by what happens in them."""

from __future__ import annotations

import numpy as np

from estimation.log_rows import Array, Log
from estimation.recording import rate_of

SETTLED = 1.0  # [s] from which on the estimator is judged


def after(log: Log, start: float) -> slice:
    """Return the rows from a time [s] on."""
    return slice(round(start * rate_of(log)), None)


def rows_of(log: Log, time: float) -> int:
    """Return the row of a time [s]."""
    return round(time * rate_of(log))


def pushes(log: Log) -> list[int]:
    """Return the rows in which pushes begin."""
    rows = [rows_of(log, float(time)) for time in log["push_times"]]
    return [row for row in rows if row < len(log["tick"]) - rows_of(log, 0.5)]


def speed(log: Log) -> Array:
    """Return the true speed (n,) of the base [m/s]."""
    return np.asarray(np.linalg.norm(log["truth_v"], axis=1))
