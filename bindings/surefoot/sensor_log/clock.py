"""Sample time of each row of a log."""

from __future__ import annotations

import numpy as np

from surefoot._core import Error
from surefoot.geometry.batch_rotations import Array

# Equal to kMaxTimeStep in state_estimator.cpp.
MAX_STEP = 0.1  # [s] largest dt that the estimator receives; longer steps are gaps
_WRAP = 2**32


def read_clock(source: str, columns: dict[str, Array]) -> tuple[str, Array]:
    """Return the name of the clock column, and the time (n,) of each row since the first row [s].

    The function uses `tick`, the clock of the robot. If `tick` is missing or constant, it uses
    `time`, which is often the clock of the recorder. Rows with a non-finite clock have time NaN.

    Raises:
        Error: The clock goes backwards, is constant, or is in a wrong unit.
    """
    names = [name for name in ("tick", "time") if name in columns]
    advancing = [name for name in names if np.ptp(_finite(columns[name][:, 0])) > 0.0]
    if not advancing and len(columns[names[0]]) == 1:
        advancing = names  # a log of one row cannot show whether its clock advances
    if not advancing:
        name, count = names[0], len(columns[names[0]])
        value = columns[name][0, 0]
        raise Error(
            f"{source}: column '{name}': got the same value {value:g} in {count} rows, "
            "expected a clock that advances"
        )
    name = advancing[0]
    stamps = columns[name][:, 0]
    good = np.isfinite(stamps)
    seconds = _tick_seconds(source, stamps[good]) if name == "tick" else stamps[good]
    steps = np.diff(seconds)
    _check_steps(source, name, steps, np.flatnonzero(good))
    time = np.full(len(stamps), np.nan)
    time[good] = seconds - seconds[0]
    return name, time


def _finite(values: Array) -> Array:
    finite = values[np.isfinite(values)]
    return finite if len(finite) else np.zeros(1)


def _tick_seconds(source: str, ticks: Array) -> Array:
    """Return the time (n,) since the first tick [s] of ticks (n,) [ms], which wrap at 2^32.

    Raises:
        Error: A tick is not a whole number from 0 to 2^32 - 1.
    """
    if np.any(ticks != np.round(ticks)) or ticks.min() < 0 or ticks.max() >= _WRAP:
        wrong = ticks[(ticks != np.round(ticks)) | (ticks < 0) | (ticks >= _WRAP)][0]
        raise Error(
            f"{source}: column 'tick': got {wrong:g}, expected whole milliseconds from 0 to "
            "2^32 - 1; name a clock in seconds 'time'"
        )
    steps = np.mod(np.diff(ticks.astype(np.int64)), _WRAP)
    steps[steps >= _WRAP // 2] -= _WRAP  # a step of half the range or more is a step back
    return np.concatenate([[0.0], 1e-3 * np.cumsum(steps)])


def _check_steps(source: str, name: str, steps: Array, rows: np.ndarray) -> None:
    back = np.flatnonzero(steps < 0.0)
    if len(back):
        k = int(back[0])
        raise Error(
            f"{source}: column '{name}': got a step of {steps[k]:g} s at row {rows[k + 1]} "
            "(counted from 0), expected a clock that never goes backwards"
        )
    if not np.any(steps > 0.0):
        return
    median = float(np.median(steps[steps > 0.0]))
    if median > MAX_STEP:
        unit = {"tick": "milliseconds", "time": "seconds"}[name]
        raise Error(
            f"{source}: column '{name}': got a median step of {median:g} s, expected at most "
            f"{MAX_STEP:g}: is it in {unit}?"
        )
