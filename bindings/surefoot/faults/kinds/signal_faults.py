"""Changes that make a signal wrong: off, stuck, garbage and so on."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

Values = npt.NDArray[Any]

Change = Callable[[Values, int], None]
"""Changes a signal in place; the int is k, the control periods since the fault began."""

INJECTIONS = ("off", "stuck", "garbage", "wrong", "slow", "delayed", "intermittent")


def off(values: Values, k: int) -> None:
    """Set the signal to zero."""
    values[...] = 0


def constant(value: float) -> Change:
    """Return a change that sets the signal to a constant."""

    def change(values: Values, k: int) -> None:
        values[...] = value

    return change


def offset(by: float | npt.ArrayLike) -> Change:
    """Return a change that adds an offset."""

    def change(values: Values, k: int) -> None:
        values[...] = values + np.asarray(by, dtype=values.dtype)

    return change


def scaled(by: float) -> Change:
    """Return a change that multiplies the signal."""

    def change(values: Values, k: int) -> None:
        values[...] = values * by

    return change


def drifting(per_tick: float) -> Change:
    """Return a change that adds an offset which grows by `per_tick` every period."""

    def change(values: Values, k: int) -> None:
        values[...] = values + np.asarray((k + 1) * per_tick).astype(values.dtype)

    return change


def garbage(size: float, whole: bool = False) -> Change:
    """Return a change to uniform random values from -size to size; `whole` rounds them."""
    rng = np.random.default_rng(7)  # any seed: runs repeat

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


def slow(ticks: int) -> Change:
    """Return a change that updates the signal only every `ticks` periods and holds it between."""
    held: list[Values] = []

    def change(values: Values, k: int) -> None:
        if k % ticks == 0:
            held[:] = [values.copy()]
        values[...] = held[0]

    return change


def stuck() -> Change:
    """Return a change that holds the value from the onset."""
    return slow(10**9)


def delayed(ticks: int) -> Change:
    """Return a change that delays the signal by `ticks` periods."""
    queue: deque[Values] = deque()

    def change(values: Values, k: int) -> None:
        queue.append(values.copy())
        values[...] = queue[0]
        if len(queue) > ticks:
            queue.popleft()

    return change


def intermittent(change: Change, every: int, length: int = 1) -> Change:
    """Return a change that acts in the first `length` of every `every` periods."""

    def change_at_intervals(values: Values, k: int) -> None:
        if k % every < length:
            change(values, k)

    return change_at_intervals


def repeated(every: int) -> Change:
    """Return a change that repeats the previous value in one of `every` periods."""
    last: list[Values] = []

    def change(values: Values, k: int) -> None:
        current = values.copy()
        if k % every == 0 and last:
            values[...] = last[0]
        last[:] = [current]

    return change


def ramp(start: float, per_second: float) -> Change:
    """Return a change to a ramp in units per second at 500 samples per second, within 0 .. 127."""

    def change(values: Values, k: int) -> None:
        values[...] = np.clip(start + per_second * k / 500.0, 0, 127)

    return change
