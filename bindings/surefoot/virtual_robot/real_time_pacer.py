"""Wall-clock time: absolute deadlines, and what is lost when they are missed."""

from __future__ import annotations

import time
from collections.abc import Callable

MAX_CATCH_UP = 0.01  # [s] that is caught up; more would be a burst of reports


class RealTimePacer:
    """Paces cycles of simulated time by a clock.

    A cycle that comes late is caught up by the next ones, up to 10 ms. What goes beyond is lost:
    simulated time then runs behind the clock, and `real_time_factor` says by how much.

    Args:
        period: Of a cycle [s].
        read_clock: The clock [s].
        sleep: Waits [s].

    Attributes:
        slipped: Time lost [s].
        cycles: Waited for.
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
        """Time by the clock since the start [s]."""
        return self._read_clock() - self._start

    @property
    def real_time_factor(self) -> float:
        """Simulated time over the clock's, since the start; 1 is real time."""
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
