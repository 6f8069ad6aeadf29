"""What a push did to the robot, in one number and its terms."""

from __future__ import annotations

from surefoot.sim import Plant
from surefoot.tune.cost import Cost, cost
from surefoot.tune.trace import Trace

SCORE_TIME = 3.0  # after the push begins


class PushScore:
    """Judges the three seconds from the beginning of the last push on.

    Args:
        plant: The plant that is pushed.

    Attributes:
        last_cost: Of the last push whose three seconds are over; None before.
    """

    def __init__(self, plant: Plant) -> None:
        self._ticks = round(SCORE_TIME * plant.settings.control_rate)
        self._trace = Trace(plant, self._ticks)
        self._ticks_left = 0
        self.last_cost: Cost | None = None

    @property
    def seconds_left(self) -> float:
        """Time until the push that is being judged has its score [s]; 0 if there is none."""
        return SCORE_TIME * self._ticks_left / self._ticks

    def begin(self) -> None:
        """A push begins."""
        self._trace.clear()
        self._ticks_left = self._ticks

    def record(self) -> None:
        """A control period has passed."""
        if self._ticks_left == 0:
            return
        self._trace.record()
        self._ticks_left -= 1
        if self._ticks_left == 0:
            self.last_cost = cost(self._trace)
