"""Pacing of simulated cycles by the wall clock, with absolute deadlines."""

from __future__ import annotations

import time
from collections.abc import Callable

# [s] Longest delay that is caught up; catching up a longer delay would cause a burst of samples.
# Equal to kHoldTime of the controller, which tolerates gaps of this length.
MAX_CATCH_UP = 0.01


class RealTimePacer:
    """Pacer that starts simulated cycles at the times of a clock.

    After a delay of at most MAX_CATCH_UP, the next cycles run faster to catch up. After a longer
    delay, all deadlines move, so the simulated time stays behind the clock.

    Args:
        period: Period of a cycle [s].
        read_clock: Function that returns the time of the clock [s].
        sleep: Function that waits for a time [s].

    Attributes:
        slipped: Sum of the delays that were not caught up [s].
        cycles: Number of calls of wait().
    """

    def __init__(
        self,
        period: float,
        read_clock: Callable[[], float] = time.monotonic,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        self._period, self._read_clock, self._sleep = period, read_clock, sleep
        self._start = self._deadline = read_clock()
        self.slipped = 0.0
        self.cycles = 0

    @property
    def elapsed(self) -> float:
        """Clock time since the start [s]."""
        return self._read_clock() - self._start

    @property
    def real_time_factor(self) -> float:
        """Ratio of simulated time to clock time since the start; 1: real time."""
        return self.cycles * self._period / max(self.elapsed, 1e-9) if self.cycles else 1.0

    def wait(self) -> None:
        """Wait until the next cycle is due."""
        self._deadline += self._period
        self.cycles += 1
        late = self._read_clock() - self._deadline
        if late < 0.0:
            self._sleep(-late)
        elif late > MAX_CATCH_UP:
            self.slipped += late
            self._deadline += late
