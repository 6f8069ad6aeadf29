"""Wall-clock time: absolute deadlines, and what is lost when they are missed."""

from __future__ import annotations

import time
from collections.abc import Callable

MOST_LATE = 0.01  # [s] that is caught up; more would be a burst of reports


class RealTime:
    """Paces cycles of simulated time by a clock.

    A cycle that comes late is caught up by the next ones, up to 10 ms. What goes beyond is lost:
    simulated time then runs behind the clock, and `factor` says by how much.

    Args:
        period: Of a cycle [s].
        now: The clock [s].
        sleep: Waits [s].

    Attributes:
        slipped: Time lost [s].
        cycles: Waited for.
    """

    def __init__(
        self,
        period: float,
        now: Callable[[], float] = time.monotonic,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        self._period, self._now, self._sleep = period, now, sleep
        self._start = self._deadline = now()
        self.slipped = 0.0
        self.cycles = 0

    @property
    def elapsed(self) -> float:
        """Time by the clock since the start [s]."""
        return self._now() - self._start

    @property
    def factor(self) -> float:
        """Simulated time over the clock's, since the start; 1 is real time."""
        return self.cycles * self._period / max(self.elapsed, 1e-9) if self.cycles else 1.0

    def wait(self) -> None:
        """Wait until the next cycle is due."""
        self._deadline += self._period
        self.cycles += 1
        late = self._now() - self._deadline
        if late < 0.0:
            self._sleep(-late)
        elif late > MOST_LATE:
            self.slipped += late
            self._deadline += late
