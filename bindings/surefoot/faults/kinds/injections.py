"""The ways in which a signal goes wrong: off, stuck, garbage and so on."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

Values = npt.NDArray[Any]

Change = Callable[[Values, int], None]
"""Changes a signal in place, k control periods after the fault began."""

INJECTIONS = ("off", "stuck", "garbage", "wrong", "slow", "delayed", "intermittent")


def off(values: Values, k: int) -> None:
    """Say zero."""
    values[...] = 0


def constant(value: float) -> Change:
    """Return what says the same number, whatever is."""

    def change(values: Values, k: int) -> None:
        values[...] = value

    return change


def offset(by: float | npt.ArrayLike) -> Change:
    """Return what adds to a signal."""

    def change(values: Values, k: int) -> None:
        values[...] = values + np.asarray(by, dtype=values.dtype)

    return change


def scaled(by: float) -> Change:
    """Return what multiplies a signal."""

    def change(values: Values, k: int) -> None:
        values[...] = values * by

    return change


def drifting(per_tick: float) -> Change:
    """Return what adds more to a signal every period."""

    def change(values: Values, k: int) -> None:
        values[...] = values + np.asarray((k + 1) * per_tick).astype(values.dtype)

    return change


def garbage(size: float, whole: bool = False) -> Change:
    """Return what says anything between -size and size."""
    rng = np.random.default_rng(7)

    def change(values: Values, k: int) -> None:
        drawn = rng.uniform(-size, size, values.shape)
        values[...] = np.round(drawn) if whole else drawn

    return change


def noise(size: float) -> Change:
    """Return what adds anything between -size and size."""
    draw = garbage(size)

    def change(values: Values, k: int) -> None:
        current = values.copy()
        draw(values, k)
        values[...] = values + current

    return change


def slow(ticks: int) -> Change:
    """Return what passes a new value on only every so many periods; 1000 and more is stuck."""
    held: list[Values] = []

    def change(values: Values, k: int) -> None:
        if k % ticks == 0:
            held[:] = [values.copy()]
        values[...] = held[0]

    return change


def stuck() -> Change:
    """Return what says for ever what was said when it began."""
    return slow(10**9)


def delayed(ticks: int) -> Change:
    """Return what says everything so many periods late."""
    queue: deque[Values] = deque()

    def change(values: Values, k: int) -> None:
        queue.append(values.copy())
        values[...] = queue[0]
        if len(queue) > ticks:
            queue.popleft()

    return change


def intermittent(change: Change, every: int, length: int = 1) -> Change:
    """Return a change that comes every so many periods for a few."""

    def change_at_intervals(values: Values, k: int) -> None:
        if k % every < length:
            change(values, k)

    return change_at_intervals


def repeated(every: int) -> Change:
    """Return what says in one period of so many what was said in the one before."""
    last: list[Values] = []

    def change(values: Values, k: int) -> None:
        current = values.copy()
        if k % every == 0 and last:
            values[...] = last[0]
        last[:] = [current]

    return change


def ramp(start: float, per_second: float) -> Change:
    """Return what says a number that grows, at 500 reports a second."""

    def change(values: Values, k: int) -> None:
        values[...] = np.clip(start + per_second * k / 500.0, 0, 127)

    return change
