"""Search for the stability limit of a loop along a factor or a delay."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

from surefoot.tune.design.closed_loop import ClosedLoop


def last_stable(unstable: Callable[[float], bool], low: float, high: float) -> tuple[float, float]:
    """Search upwards from a stable `low` for the first unstable value.

    Returns:
        A stable value, and an unstable value at most 1 % above it. (high, high): all values up to
        `high` are stable.
    """
    upper = low
    # Search in steps of 30 % first, then find the boundary to 1 %.
    while not unstable(upper := 1.3 * upper):
        low = upper
        if upper >= high:
            return high, high
    while upper > 1.01 * low:
        middle = math.sqrt(low * upper)
        low, upper = (low, middle) if unstable(middle) else (middle, upper)
    return min(low, high), min(upper, high)


def first_unstable(unstable: Callable[[float], bool], low: float, high: float) -> float:
    """Return the first unstable value above a stable `low`, to 1 %; `high` if all are stable."""
    stable, not_stable = last_stable(unstable, low, high)
    return math.sqrt(stable * not_stable)


def find_delay_margin(loop: ClosedLoop, unstable: Callable[[ClosedLoop], bool]) -> float:
    """Return the additional delay [s] at which a loop becomes unstable.

    0: the loop is unstable without additional delay. timing.max_extra_delay: the loop is stable up
    to this delay.
    """

    def with_extra_delay(delay: float) -> ClosedLoop:
        timing = replace(loop.timing, delay=loop.timing.delay + delay)
        return ClosedLoop(loop.direction, timing, loop.observers)

    if unstable(loop):
        return 0.0
    max_delay = loop.timing.max_extra_delay
    low, step = 0.0, min(0.001, max_delay)
    # Search upwards from 0, because a loop may be stable again beyond the first unstable delay.
    while not unstable(with_extra_delay(step)):
        if step >= max_delay:
            return max_delay
        low, step = step, min(1.3 * step, max_delay)
    # Resolution of the delay margin: 0.1 ms, as it is printed.
    while step - low > 0.0001:
        middle = 0.5 * (low + step)
        low, step = (low, middle) if unstable(with_extra_delay(middle)) else (middle, step)
    return 0.5 * (low + step)
