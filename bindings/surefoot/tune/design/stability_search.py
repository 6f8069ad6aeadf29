"""Where a loop that is stable first is not, along a factor or a delay."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

from surefoot.tune.design.closed_loop import ClosedLoop


def last_stable(unstable: Callable[[float], bool], low: float, high: float) -> tuple[float, float]:
    """Return a stable place, from `low` on, and an unstable one 1 % above; `high` twice if none."""
    upper = low
    while not unstable(upper := 1.3 * upper):
        low = upper
        if upper >= high:
            return high, high
    while upper > 1.01 * low:
        middle = math.sqrt(low * upper)
        low, upper = (low, middle) if unstable(middle) else (middle, upper)
    return min(low, high), min(upper, high)


def first_unstable(unstable: Callable[[float], bool], low: float, high: float) -> float:
    """Return where a loop that is stable at `low` first is not, to 1 %; `high` if nowhere."""
    stable, not_stable = last_stable(unstable, low, high)
    return math.sqrt(stable * not_stable)


def find_delay_margin(loop: ClosedLoop, unstable: Callable[[ClosedLoop], bool]) -> float:
    """Return the delay [s] that makes a loop unstable, beyond what it has; `max_extra_delay` if none."""

    def with_extra_delay(delay: float) -> ClosedLoop:
        timing = replace(loop.timing, delay=loop.timing.delay + delay)
        return ClosedLoop(loop.direction, timing, loop.observers)

    if unstable(loop):
        return 0.0
    max_delay = loop.timing.max_extra_delay
    low, step = 0.0, min(0.001, max_delay)
    # Upwards from nothing: with enough delay every loop is unstable, and may seem stable beyond.
    while not unstable(with_extra_delay(step)):
        if step >= max_delay:
            return max_delay
        low, step = step, min(1.3 * step, max_delay)
    while step - low > 0.0001:
        middle = 0.5 * (low + step)
        low, step = (low, middle) if unstable(with_extra_delay(middle)) else (middle, step)
    return 0.5 * (low + step)
