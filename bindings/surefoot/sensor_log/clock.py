"""Sample time of each row of a log."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from surefoot._core import Error
from surefoot.geometry.batch_rotations import Array
from surefoot.sensor_log.clock_unit import (
    OWN_UNITS,
    UNITS,
    check_duration,
    check_whole_stamps,
    find_unit,
)
from surefoot.sensor_log.log_table import row_place

# Share of rows that repeat the clock, above which the clock is too coarse. Chosen: a log at 1 kHz
# of a robot at 250 Hz repeats 0.75.
MAX_REPEATED = 0.9
_WRAP = 2**32


def read_clock(
    source: str,
    columns: dict[str, Array],
    place: Callable[[int], str] = row_place,
    notes: list[str] | None = None,
    time_unit: str | None = None,
) -> tuple[str, Array]:
    """Return the name of the clock column, and the time (n,) of each row since the first row [s].

    The function uses `tick`, the clock of the robot. If `tick` is missing or constant, it uses
    `time`, which is often the clock of the recorder. Rows with a non-finite clock have time NaN.
    The median step tells the unit if the column's name does not: steps are expected between 0.4 ms
    and 0.1 s. Clocks in other units than the column's own count whole numbers.

    Args:
        source: Name of the log, for messages.
        columns: Columns of the log by name.
        place: Function that returns the place of a row in the file, for messages.
        notes: List that receives a sentence about each conversion.
        time_unit: Unit that the name of `time` in the file states, or None.

    Raises:
        Error: The clock goes backwards, is constant or too coarse, or no unit fits its steps.
    """
    notes = [] if notes is None else notes
    advancing = _advancing_clocks(source, columns)
    name = advancing[0]
    stamps = columns[name][:, 0]
    good = np.isfinite(stamps)
    rows = np.flatnonzero(good)
    elapsed = _elapsed(source, name, stamps[good], rows, place)
    steps = np.diff(elapsed)
    _check_steps(source, name, stamps, steps, rows, place)
    stated = time_unit if name == "time" else None
    unit, own_unit = find_unit(source, name, steps, stated), OWN_UNITS[name]
    if unit != own_unit:
        if stated is None:
            check_whole_stamps(source, name, stamps[good])
        if name == "tick" and "time" in advancing:
            check_duration(source, UNITS[unit] * elapsed, columns["time"][:, 0], time_unit)
        notes.append(f"column '{name}' is read in {unit} and converted to {own_unit}")
    repeated = np.flatnonzero(steps == 0.0)
    if len(repeated):
        notes.append(
            f"{len(repeated)} rows repeat the clock '{name}' of the row before and are skipped; "
            f"the first is {place(int(rows[repeated[0] + 1]))}"
        )
    time = np.full(len(stamps), np.nan)
    time[good] = UNITS[unit] * elapsed
    return name, time


def _advancing_clocks(source: str, columns: dict[str, Array]) -> list[str]:
    """Return the names of the clocks that advance, the best first; raise Error if none does."""
    names = [name for name in OWN_UNITS if name in columns]
    advancing = [name for name in names if np.ptp(_finite(columns[name][:, 0])) > 0.0]
    count = len(columns[names[0]])
    if not advancing and count > 1:  # a log of one row cannot show whether its clock advances
        value = columns[names[0]][0, 0]
        raise Error(
            f"{source}: column '{names[0]}': got the same value {value:g} in {count} rows, "
            "expected a clock that advances"
        )
    return advancing or names


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
