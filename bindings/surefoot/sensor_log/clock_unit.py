"""Unit of a clock, from the name of its column or from its steps."""

from __future__ import annotations

import numpy as np

from surefoot._core import Error
from surefoot.geometry.batch_rotations import Array

# Equal to kMaxTimeStep in state_estimator.cpp.
MAX_STEP = 0.1  # [s] largest dt that the estimator receives; longer steps are gaps
# [s] Smallest median step. Chosen: logs of up to 2.5 kHz are read. It is larger than
# MAX_STEP / 1000, so one unit fits at most, and steps of 0.1 s to 0.4 s fit none.
MIN_STEP = 4e-4
# Largest ratio of the durations by `tick` and `time`. Chosen: clocks of robot and recorder drift by
# less than 1e-4, and a wrong unit is a factor of 1000.
MAX_DURATION_RATIO = 1.5
UNITS = {"seconds": 1.0, "milliseconds": 1e-3, "microseconds": 1e-6, "nanoseconds": 1e-9}
OWN_UNITS = {"tick": "milliseconds", "time": "seconds"}


def find_unit(source: str, name: str, steps: Array, stated: str | None) -> str:
    """Return the unit of a clock with these steps.

    Args:
        source: Name of the log, for messages.
        name: Name of the clock's column.
        steps: (n,) steps of the clock in its unit.
        stated: Unit that the name in the file states, or None.

    Raises:
        Error: The median step is outside MIN_STEP .. MAX_STEP in every unit, or in the stated one.
    """
    positive = steps[steps > 0.0]
    if len(positive) == 0:
        return stated or OWN_UNITS[name]  # a log of one row
    median = float(np.median(positive))
    for unit in [stated] if stated else UNITS:
        # The margin lets a step of 0.1 s pass that is rounded.
        if MIN_STEP < median * UNITS[unit] * (1.0 - 1e-9) <= MAX_STEP:
            return unit
    raise Error(
        f"{source}: column '{name}': got a median step of {median:g}, expected {MIN_STEP:g} .. "
        f"{MAX_STEP:g} s in {stated or ', '.join(UNITS)}"
    )


def check_whole_stamps(source: str, name: str, stamps: Array) -> None:
    """Raise Error if a clock in another unit than its column's own has fractions.

    A slow log in the own unit has the same steps: those of a log at 1 Hz, 1 s, may also be 1 ms.
    """
    wrong = stamps[stamps != np.round(stamps)]
    if len(wrong):
        raise Error(
            f"{source}: column '{name}': got {wrong[0]:.12g} and a median step of "
            f"{np.median(np.diff(stamps)):g}, expected steps of up to {MAX_STEP:g} s, or whole "
            "numbers in another unit"
        )


def check_duration(source: str, elapsed: Array, time: Array, time_unit: str | None) -> None:
    """Raise Error if `tick` in another unit than milliseconds contradicts the column `time`.

    Args:
        source: Name of the log, for messages.
        elapsed: (n,) time by `tick` since the first row [s].
        time: (n,) column `time`.
        time_unit: Unit that the name of `time` states, or None.
    """
    time = time[np.isfinite(time)]
    other = np.ptp(time) * UNITS[find_unit(source, "time", np.diff(time), time_unit)]
    ratio = max(elapsed[-1], other) / max(min(elapsed[-1], other), 1e-9)
    if ratio > MAX_DURATION_RATIO:
        raise Error(
            f"{source}: column 'tick': got a duration of {elapsed[-1]:g} s, expected that of "
            f"column 'time', {other:g} s"
        )
