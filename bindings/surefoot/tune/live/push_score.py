"""What a push did to the robot, in one number and its terms."""

from __future__ import annotations

from surefoot.sim import Plant
from surefoot.tune.cost import Cost, cost
from surefoot.tune.trace import Trace

SECONDS = 3.0  # after the push begins


class PushScore:
    """Judges the three seconds from the beginning of the last push on.

    Args:
        plant: The plant that is pushed.

    Attributes:
        last: Of the last push whose three seconds are over; None before.
    """

    def __init__(self, plant: Plant) -> None:
        self._ticks = round(SECONDS * plant.settings.control_rate)
        self._trace = Trace(plant, self._ticks)
        self._left = 0
        self.last: Cost | None = None

    @property
    def seconds_left(self) -> float:
        """Time until the push that is being judged has its score [s]; 0 if there is none."""
        return SECONDS * self._left / self._ticks

    def begin(self) -> None:
        """A push begins."""
        self._trace.clear()
        self._left = self._ticks

    def record(self) -> None:
        """A control period has passed."""
        if self._left == 0:
            return
        self._trace.record()
        self._left -= 1
        if self._left == 0:
            self.last = cost(self._trace)
