"""Editor of gains, with history and two stored sets, A and B."""

from __future__ import annotations

import time
from collections.abc import Callable

from surefoot._core import Gains, get_gain, set_gain
from surefoot.robot.gain_files import changed_gains

_MERGE_TIME = 1.0  # [s]; changes of one gain in quicker succession are undone together
_MAX_HISTORY = 200  # sets of gains that can be undone

SLOTS = ("A", "B")


class GainEditor:
    """Desired gains and their history; a session passes them to its controller.

    Args:
        robot_gains: The robot's own gains.
        start: Initial gains; None: the robot's own.
        check: Raises Error for gains that are not permitted; None permits all valid gains.
        now: Function that returns the clock [s].

    Attributes:
        robot_gains: The robot's own gains.
        version: Number of changes.
        revision: Number of changes that no slider made, and of refused ones; sliders must follow.
        slots: Gains stored as A and B.
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
        self.version = self.revision = 0
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
        """Set one gain; undo() merges quick successive changes of one gain; raises Error."""
        gains = self.gains
        try:
            set_gain(gains, name, value)
            self._validate(gains)
        except Exception:
            self.revision += 1  # sliders must show the old value again
            raise
        if gains == self._gains:
            return
        last_name, last_time = self._last_change
        if name != last_name or self._clock() - last_time > _MERGE_TIME:
            self._save_history()
        self._last_change = (name, self._clock())
        self._gains = gains
        self.version += 1

    def replace(self, gains: Gains) -> None:
        """Replace all gains; raises Error and changes nothing if one is not permitted."""
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
        """Use the gains stored as A or B; return False if there are none; raises Error."""
        if slot not in self.slots:
            return False
        self.replace(self.slots[slot])
        return True

    def changed(self) -> dict[str, tuple[float, float]]:
        """Return the gains that differ from the robot's own: (own, present) value by name."""
        return differences(self.robot_gains, self._gains)

    def _validate(self, gains: Gains) -> None:
        gains.validate()
        if self._check is not None:
            self._check(gains)

    def _save_history(self) -> None:
        self._history = [*self._history[-_MAX_HISTORY:], self._gains]

    def _set_gains(self, gains: Gains) -> None:
        self._gains, self._last_change = gains, ("", 0.0)
        self.version += 1
        self.revision += 1


def differences(first: Gains, second: Gains) -> dict[str, tuple[float, float]]:
    """Return the gains that differ: (first, second) value by name."""
    changed = changed_gains(second, first)
    return {name: (get_gain(first, name), value) for name, value in changed.items()}
