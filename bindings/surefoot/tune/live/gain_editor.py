"""Editor of gains, with history and two stored sets, A and B."""

from __future__ import annotations

import time
from collections.abc import Callable

from surefoot._core import Gains, get_gain, set_gain
from surefoot.robot.gain_files import changed_gains

# Chosen for a person: one drag of a slider is one step of undo.
_MERGE_TIME = 1.0  # [s] changes of one gain within this time are undone together
_MAX_HISTORY = 200  # number of changes that can be undone

SLOTS = ("A", "B")


class GainEditor:
    """Editor of the desired gains, with their history. A session passes them to its controller.

    Args:
        robot_gains: The robot's own gains.
        start: Initial gains. None: the robot's own gains.
        check: Function that raises Error for gains that are not permitted. None: all valid gains
            are permitted.
        now: Function that returns the time of a clock [s].

    Attributes:
        robot_gains: The robot's own gains.
        gains_version: Number of changes of the gains. When it grows, the controller needs the new
            gains.
        slider_version: Number of events after which the sliders must be updated: refused changes,
            and changes without a slider (undo, file, A or B).
        slots: Stored gains, by "A" and "B".
    """

    def __init__(
        self,
        robot_gains: Gains,
        start: Gains | None = None,
        check: Callable[[Gains], None] | None = None,
        now: Callable[[], float] = time.monotonic,
    ) -> None:
        self.robot_gains = robot_gains.__copy__()
        self._gains = (robot_gains if start is None else start).__copy__()
        self._check, self._clock = check, now
        self._history: list[Gains] = []
        self._last_change: tuple[str, float] = ("", 0.0)
        self.gains_version = self.slider_version = 0
        self.slots: dict[str, Gains] = {}
        self._validate(self._gains)

    @property
    def gains(self) -> Gains:
        """Copy of the desired gains."""
        return self._gains.__copy__()

    def get(self, name: str) -> float:
        """Return the value of a gain."""
        return get_gain(self._gains, name)

    def set(self, name: str, value: float) -> None:
        """Set one gain; undo() undoes changes of one gain within 1 s of each other together.

        Raises:
            Error: The gain is unknown, or its value is not permitted.
        """
        gains = self.gains
        try:
            set_gain(gains, name, value)
            self._validate(gains)
        except Exception:
            self.slider_version += 1  # sliders must show the old value again
            raise
        if gains == self._gains:
            return
        last_name, last_time = self._last_change
        if name != last_name or self._clock() - last_time > _MERGE_TIME:
            self._save_history()
        self._last_change = (name, self._clock())
        self._gains = gains
        self.gains_version += 1

    def replace(self, gains: Gains) -> None:
        """Replace all gains; if one is not permitted, raise Error without any change."""
        self._validate(gains)
        self._save_history()
        self._set_gains(gains.__copy__())

    def undo(self) -> bool:
        """Undo the last change; return False if there is none."""
        if not self._history:
            return False
        self._set_gains(self._history.pop())
        return True

    def store(self, slot: str) -> None:
        """Store the gains as A or B."""
        self.slots = {**self.slots, slot: self.gains}

    def use(self, slot: str) -> bool:
        """Replace the gains by those stored as A or B; return False if none are stored.

        Raises:
            Error: A stored gain is not permitted.
        """
        if slot not in self.slots:
            return False
        self.replace(self.slots[slot])
        return True

    def changed(self) -> dict[str, tuple[float, float]]:
        """Return (own value, present value) by name, for gains that differ from the robot's own."""
        return differences(self.robot_gains, self._gains)

    def _validate(self, gains: Gains) -> None:
        gains.validate()
        if self._check is not None:
            self._check(gains)

    def _save_history(self) -> None:
        self._history = [*self._history[-_MAX_HISTORY:], self._gains]

    def _set_gains(self, gains: Gains) -> None:
        self._gains, self._last_change = gains, ("", 0.0)
        self.gains_version += 1
        self.slider_version += 1


def differences(first: Gains, second: Gains) -> dict[str, tuple[float, float]]:
    """Return (first value, second value) by name, for gains that differ."""
    changed = changed_gains(second, first)
    return {name: (get_gain(first, name), value) for name, value in changed.items()}
