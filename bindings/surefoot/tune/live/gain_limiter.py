"""Limits of gains and of their rate of change, for a robot on UDP."""

from __future__ import annotations

import math

from surefoot._core import Error, Gains, gain_table, get_gain, set_gain

# Chosen: equal to WARN_GAIN_MARGIN of tune design. The robots' gain margins exceed this factor with
# up to 12 ms of additional delay.
RANGE_FACTOR = 2.0  # a gain ranges from the robot's own value / factor to own value * factor
# Chosen: slower than the robot settles, so that a person sees the effect and can stop.
LOG_RATE = math.log(2.0)  # [1/s] rate of a gain's logarithm: doubling a gain takes 1 s


class GainLimiter:
    """Limiter of gains to ranges around the robot's own gains, and of their rate of change.

    A gain's range is from own value / `factor` to own value * `factor`, limited to the range in
    gain_table(). A gain whose own value is zero stays zero.

    Args:
        robot_gains: The robot's own gains.
        factor: Factor of the ranges, above 1.
        rate: Greatest rate of a gain's natural logarithm [1/s].
    """

    def __init__(
        self, robot_gains: Gains, factor: float = RANGE_FACTOR, rate: float = LOG_RATE
    ) -> None:
        self._rate = rate
        self._ranges = {}
        for row in gain_table():
            value = get_gain(robot_gains, row.name)
            low, high = max(row.minimum, value / factor), min(row.maximum, value * factor)
            self._ranges[row.name] = (min(low, value), max(high, value))

    def limits(self, name: str) -> tuple[float, float]:
        """Return the least and the greatest value of a gain."""
        return self._ranges[name]

    def check(self, gains: Gains) -> None:
        """Raise Error if a gain is out of its range; the message names the first such gain."""
        for name, (low, high) in self._ranges.items():
            value = get_gain(gains, name)
            # Allow rounding errors of gains that a file states with fewer digits.
            slack = 1e-6 * high
            if not low - slack <= value <= high + slack:
                raise Error(
                    f"gain '{name}': got {value:g}, expected {low:g} to {high:g} for a robot on UDP"
                )

    def step_towards(self, present: Gains, desired: Gains, seconds: float) -> Gains:
        """Return `present`, moved towards `desired` as far as the rate permits in `seconds`."""
        gains = present.__copy__()
        ratio = math.exp(self._rate * seconds)
        for name in self._ranges:
            now, target = get_gain(present, name), get_gain(desired, name)
            if now != target:
                set_gain(gains, name, min(max(target, now / ratio), now * ratio))
        return gains
