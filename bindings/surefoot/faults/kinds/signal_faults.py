"""Changes that make a signal wrong: off, stuck, garbage and so on."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

Values = npt.NDArray[Any]

Change = Callable[[Values, int], None]
"""Function that changes a signal in place; its second argument k counts periods since the onset."""

INJECTIONS = ("off", "stuck", "garbage", "wrong", "slow", "delayed", "intermittent")
"""Kinds of injections: the allowed values of Case.injection."""


def off(values: Values, k: int) -> None:
    """Set the signal to zero."""
    values[...] = 0


def constant(value: float) -> Change:
    """Return a change that sets the signal to a value."""

    def change(values: Values, k: int) -> None:
        values[...] = value

    return change


def offset(by: float | npt.ArrayLike) -> Change:
    """Return a change that adds an offset."""

    def change(values: Values, k: int) -> None:
        values[...] = values + np.asarray(by, dtype=values.dtype)

    return change


def scaled(by: float) -> Change:
    """Return a change that multiplies the signal by a factor."""

    def change(values: Values, k: int) -> None:
        values[...] = values * by

    return change


def drifting(per_period: float) -> Change:
    """Return a change that adds an offset, which grows by `per_period` in every period."""

    def change(values: Values, k: int) -> None:
        values[...] = values + np.asarray((k + 1) * per_period).astype(values.dtype)

    return change


def garbage(size: float, whole: bool = False) -> Change:
    """Return a change that sets the signal to uniform random values from -size to size.

    Args:
        size: Largest absolute value, in the unit of the signal.
        whole: True: round the values to whole numbers.
    """
    rng = np.random.default_rng(7)  # any fixed seed, so that runs repeat

    def change(values: Values, k: int) -> None:
        drawn = rng.uniform(-size, size, values.shape)
        values[...] = np.round(drawn) if whole else drawn

    return change


def noise(size: float) -> Change:
    """Return a change that adds uniform noise from -size to size."""
    draw = garbage(size)

    def change(values: Values, k: int) -> None:
        current = values.copy()
        draw(values, k)
        values[...] = values + current

    return change


def slow(period_count: int) -> Change:
    """Return a change that holds the signal and updates it once in `period_count` periods."""
    held: list[Values] = []

    def change(values: Values, k: int) -> None:
        if k % period_count == 0:
            held[:] = [values.copy()]
        values[...] = held[0]

    return change


def stuck() -> Change:
    """Return a change that holds the value that the signal has at the onset."""
    return slow(10**9)


def delayed(period_count: int) -> Change:
    """Return a change that delays the signal by `period_count` periods.

    Until then, the signal keeps the value that it has at the onset.
    """
    queue: deque[Values] = deque()

    def change(values: Values, k: int) -> None:
        queue.append(values.copy())
        values[...] = queue[0]
        if len(queue) > period_count:
            queue.popleft()

    return change


def intermittent(change: Change, every: int, length: int = 1) -> Change:
    """Return a change that acts in the first `length` periods of each cycle of `every` periods."""

    def change_at_intervals(values: Values, k: int) -> None:
        if k % every < length:
            change(values, k)

    return change_at_intervals


def repeated(every: int) -> Change:
    """Return a change that, in one of `every` periods, repeats the value of the period before."""
    last: list[Values] = []

    def change(values: Values, k: int) -> None:
        current = values.copy()
        if k % every == 0 and last:
            values[...] = last[0]
        last[:] = [current]

    return change


def ramp(start: float, per_second: float) -> Change:
    """Return a change that sets the signal to a ramp, clipped to 0 .. 127.

    Args:
        start: First value, in the unit of the signal.
        per_second: Slope in units per second, for 500 samples per second.
    """

    def change(values: Values, k: int) -> None:
        values[...] = np.clip(start + per_second * k / 500.0, 0, 127)

    return change
