"""Recorder of the last push; the score is the cost of the 3 s after the push has begun."""

from __future__ import annotations

from surefoot.sim import Plant
from surefoot.tune.cost import Cost, cost
from surefoot.tune.trace import Trace

# Chosen: a push of 0.1 s is settled within about 1 s; a slow fall takes longer.
SCORE_TIME = 3.0  # [s] duration of a recording, from the beginning of the push


class PushScore:
    """Recorder that computes the cost (here also called score) of the last push.

    Args:
        plant: The plant that is pushed.

    Attributes:
        last_cost: Cost of the last push with a complete recording. None: no recording is complete.
    """

    def __init__(self, plant: Plant) -> None:
        self._ticks = round(SCORE_TIME * plant.settings.control_rate)
        self._trace = Trace(plant, self._ticks)
        self._ticks_left = 0
        self.last_cost: Cost | None = None

    @property
    def seconds_left(self) -> float:
        """Time [s] until the present recording is complete; 0: nothing is being recorded."""
        return SCORE_TIME * self._ticks_left / self._ticks

    def begin(self) -> None:
        """Start a new recording; call when a push begins."""
        self._trace.clear()
        self._ticks_left = self._ticks

    def stop(self) -> None:
        """End the present recording without a cost."""
        self._ticks_left = 0

    def record(self) -> None:
        """Record a control period; call after each tick."""
        if self._ticks_left == 0:
            return
        self._trace.record()
        self._ticks_left -= 1
        if self._ticks_left == 0:
            self.last_cost = cost(self._trace)
