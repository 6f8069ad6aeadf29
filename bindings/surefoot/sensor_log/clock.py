"""Sample time of each row of a log."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from surefoot._core import Error
from surefoot.geometry.batch_rotations import Array
from surefoot.sensor_log.log_table import row_place

# Equal to kMaxTimeStep in state_estimator.cpp.
MAX_STEP = 0.1  # [s] largest dt that the estimator receives; longer steps are gaps
# [s] Smallest median step. Derived: MAX_STEP / 1000, so that exactly one unit of _UNITS fits.
MIN_STEP = 1e-4
_UNITS = {"seconds": 1.0, "milliseconds": 1e-3, "microseconds": 1e-6, "nanoseconds": 1e-9}
# Share of rows that repeat the clock, above which the clock is too coarse. Chosen: a log at 1 kHz
# of a robot at 250 Hz repeats 0.75.
MAX_REPEATED = 0.9
_WRAP = 2**32


def read_clock(
    source: str,
    columns: dict[str, Array],
    place: Callable[[int], str] = row_place,
    notes: list[str] | None = None,
) -> tuple[str, Array]:
    """Return the name of the clock column, and the time (n,) of each row since the first row [s].

    The function uses `tick`, the clock of the robot. If `tick` is missing or constant, it uses
    `time`, which is often the clock of the recorder. Rows with a non-finite clock have time NaN.
    The median step tells the unit: steps are expected between 0.1 ms and 0.1 s.

    Args:
        source: Name of the log, for messages.
        columns: Columns of the log by name.
        place: Function that returns the place of a row in the file, for messages.
        notes: List that receives a sentence about each conversion.

    Raises:
        Error: The clock goes backwards, is constant or too coarse, or no unit fits its steps.
    """
    notes = [] if notes is None else notes
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
    rows = np.flatnonzero(good)
    elapsed = _elapsed(source, name, stamps[good], rows, place)
    steps = np.diff(elapsed)
    _check_steps(source, name, stamps, steps, rows, place)
    unit = _unit(source, name, steps)
    own_unit = "milliseconds" if name == "tick" else "seconds"
    if unit != own_unit:
        notes.append(f"column '{name}' is read in {unit} and converted to {own_unit}")
    repeated = np.flatnonzero(steps == 0.0)
    if len(repeated):
        notes.append(
            f"{len(repeated)} rows repeat the clock '{name}' of the row before and are skipped; "
            f"the first is {place(int(rows[repeated[0] + 1]))}"
        )
    time = np.full(len(stamps), np.nan)
    time[good] = _UNITS[unit] * elapsed
    return name, time


def _finite(values: Array) -> Array:
    finite = values[np.isfinite(values)]
    return finite if len(finite) else np.zeros(1)


def _elapsed(
    source: str, name: str, stamps: Array, rows: npt.NDArray[np.int64], place: Callable[[int], str]
) -> Array:
    """Return the time (n,) since the first stamp, in the unit of the stamps; ticks wrap at 2^32.

    Raises:
        Error: A tick is not a whole number from 0 to 2^32 - 1.
    """
    if name == "time":
        return stamps - stamps[:1]
    wrong = np.flatnonzero((stamps != np.round(stamps)) | (stamps < 0) | (stamps >= _WRAP))
    if len(wrong):
        row = int(wrong[0])
        raise Error(
            f"{source}: {place(int(rows[row]))}, column 'tick': got {stamps[row]:g}, expected "
            "whole milliseconds from 0 to 2^32 - 1; name a clock in seconds 'time'"
        )
    steps = np.mod(np.diff(stamps.astype(np.int64)), _WRAP)
    steps[steps >= _WRAP // 2] -= _WRAP  # a step of half the range or more is a step back
    return np.concatenate([[0.0], np.cumsum(steps)])


def _check_steps(
    source: str,
    name: str,
    stamps: Array,
    steps: Array,
    rows: npt.NDArray[np.int64],
    place: Callable[[int], str],
) -> None:
    """Raise Error if the clock goes backwards, or repeats its value in nearly every row."""
    back = np.flatnonzero(steps < 0.0)
    if len(back):
        before, row = (int(rows[back[0] + k]) for k in (0, 1))
        raise Error(
            f"{source}: {place(row)}, column '{name}': got {stamps[row]:.12g} after "
            f"{stamps[before]:.12g}, expected a clock that never goes backwards; sort the rows, "
            "or split the log"
        )
    if len(steps) and np.mean(steps == 0.0) > MAX_REPEATED:
        raise Error(
            f"{source}: column '{name}': got the value of the row before in "
            f"{np.count_nonzero(steps == 0.0)} of {len(rows)} rows, expected a new one in each; "
            "were its digits cut off?"
        )


def _unit(source: str, name: str, steps: Array) -> str:
    """Return the unit of a clock with these steps.

    Raises:
        Error: The median step is outside 0.1 ms .. 0.1 s in every unit.
    """
    own_unit = "milliseconds" if name == "tick" else "seconds"
    positive = steps[steps > 0.0]
    if len(positive) == 0:
        return own_unit  # a log of one row
    median = float(np.median(positive))
    for unit, scale in _UNITS.items():
        # The margin lets a step of 0.1 s pass that is rounded.
        if MIN_STEP < median * scale * (1.0 - 1e-9) <= MAX_STEP:
            return unit
    raise Error(
        f"{source}: column '{name}': got a median step of {median:g}, expected {MIN_STEP:g} .. "
        f"{MAX_STEP:g} s: is it in seconds, milliseconds, microseconds or nanoseconds?"
    )
