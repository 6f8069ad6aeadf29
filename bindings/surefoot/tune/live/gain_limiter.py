"""How far and how fast gains may go on a robot that is not simulated here."""

from __future__ import annotations

import math

from surefoot._core import Error, Gains, gain_table, get_gain, set_gain

RANGE_FACTOR = 2.0  # of the robot's own value, up and down
LOG_RATE = math.log(2.0)  # [1/s] of a gain's logarithm: a second from the own value to its double


class GainLimiter:
    """Ranges around a robot's own gains, and a limited speed within them.

    Every gain may be between its own value divided and multiplied by a factor, and in the
    table's range. One that is zero stays zero.

    Args:
        robot_gains: The robot's own gains.
        factor: Above 1.
        rate: Greatest change of a gain's natural logarithm [1/s].
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
        """Raise Error naming the first gain that is out of its range."""
        for name, (low, high) in self._ranges.items():
            value = get_gain(gains, name)
            # A file that was written with fewer digits than a number has may be off by as much.
            slack = 1e-6 * high
            if not low - slack <= value <= high + slack:
                raise Error(
                    f"gain '{name}': got {value:g}, expected {low:g} to {high:g} while a robot "
                    "stands on it"
                )

    def step_towards(self, present: Gains, wanted: Gains, seconds: float) -> Gains:
        """Return the present gains, moved towards the wanted ones by what a time [s] allows."""
        gains = present.__copy__()
        ratio = math.exp(self._rate * seconds)
        for name in self._ranges:
            now, target = get_gain(present, name), get_gain(wanted, name)
            if now != target:
                set_gain(gains, name, min(max(target, now / ratio), now * ratio))
        return gains
