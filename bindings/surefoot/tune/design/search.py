"""Where a loop that is stable first is not, along a factor or a delay."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

from surefoot.tune.design.loop import ClosedLoop

MOST_DELAY = 0.1  # [s] longer margins are not told apart


def first_unstable(unstable: Callable[[float], bool], low: float, high: float) -> float:
    """Return where a loop that is stable at `low` first is not, to 1 %; `high` if nowhere."""
    upper = low
    while not unstable(upper := 1.3 * upper):
        low = upper
        if upper >= high:
            return high
    while upper > 1.01 * low:
        middle = math.sqrt(low * upper)
        low, upper = (low, middle) if unstable(middle) else (middle, upper)
    return min(math.sqrt(low * upper), high)


def more_delay(loop: ClosedLoop, unstable: Callable[[ClosedLoop], bool]) -> float:
    """Return the delay [s] that makes a loop unstable, beyond what it has; MOST_DELAY if none."""

    def later(delay: float) -> ClosedLoop:
        timing = replace(loop.timing, delay=loop.timing.delay + delay)
        return ClosedLoop(loop.direction, timing, loop.observers)

    if unstable(loop):
        return 0.0
    step = 0.001
    # Upwards from nothing: with enough delay every loop is unstable, and may seem stable beyond.
    while step < MOST_DELAY and not unstable(later(step)):
        step *= 1.3
    if step >= MOST_DELAY:
        return MOST_DELAY
    low = step / 1.3 if step > 0.001 else 0.0
    while step - low > 0.0001:
        middle = 0.5 * (low + step)
        low, step = (low, middle) if unstable(later(middle)) else (middle, step)
    return 0.5 * (low + step)
