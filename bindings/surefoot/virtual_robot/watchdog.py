"""Watchdog that detects missing commands to a virtual robot."""

from __future__ import annotations


class Watchdog:
    """Detector of missing commands.

    Before the first command, no commands are missing.

    Args:
        timeout: Time without a valid command after which commands are missing [s]; 0: never.

    Attributes:
        received_any: True after the first command.
        intervals: Start and end of each interval with missing commands [s]; the end is None while
            the interval lasts.
    """

    def __init__(self, timeout: float) -> None:
        self._timeout = timeout
        self._last_command_time = 0.0
        self.received_any = False
        self.intervals: list[tuple[float, float | None]] = []

    @property
    def damping(self) -> bool:
        """True while commands are missing."""
        return bool(self.intervals) and self.intervals[-1][1] is None

    def feed(self, time: float) -> bool:
        """Register a valid command at a time [s]; return True if commands were missing before."""
        was_damping = self.damping
        if was_damping:
            self.intervals[-1] = (self.intervals[-1][0], time)
        self.received_any, self._last_command_time = True, time
        return was_damping

    def check_timeout(self, time: float) -> bool:
        """Begin an interval if the timeout is over at a time [s]; return True if it begins now."""
        if not self.received_any or self.damping or self._timeout <= 0.0:
            return False
        # Times are sums of periods. Without a tolerance, rounding errors could add a cycle.
        if time - self._last_command_time < self._timeout - 1e-9:
            return False
        self.intervals.append((time, None))
        return True
