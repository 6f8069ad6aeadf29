"""What happens when commands stop."""

from __future__ import annotations


class Watchdog:
    """Notices that no valid command came for too long, and that they came back.

    Args:
        timeout: How long is too long [s]; 0 never is.

    Attributes:
        received_any: Whether any command ever came; before that nothing is missed.
        intervals: Begin and end of every time they were [s]; the end is None while it lasts.
    """

    def __init__(self, timeout: float) -> None:
        self._timeout = timeout
        self._last_command_time = 0.0
        self.received_any = False
        self.intervals: list[tuple[float, float | None]] = []

    @property
    def damping(self) -> bool:
        """Whether commands are missing now."""
        return bool(self.intervals) and self.intervals[-1][1] is None

    def feed(self, time: float) -> bool:
        """Tell of a valid command at a time [s]; return whether they had been missing."""
        was_damping = self.damping
        if was_damping:
            self.intervals[-1] = (self.intervals[-1][0], time)
        self.received_any, self._last_command_time = True, time
        return was_damping

    def expires(self, time: float) -> bool:
        """Return whether commands begin to be missing at this time [s]."""
        if not self.received_any or self.damping or self._timeout <= 0.0:
            return False
        # Times are sums of periods: a rounding error must not cost a cycle.
        if time - self._last_command_time < self._timeout - 1e-9:
            return False
        self.intervals.append((time, None))
        return True
