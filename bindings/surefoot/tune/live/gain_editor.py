"""The gains that are wanted, what they were before, and two sets of them to compare."""

from __future__ import annotations

import time
from collections.abc import Callable

from surefoot._core import Gains, get_gain, set_gain
from surefoot.robot.gain_files import changed_gains

_MERGE_TIME = 1.0  # [s]; changes of one gain that follow each other faster are undone at once
_MAX_HISTORY = 200  # sets of gains that are remembered

SLOTS = ("A", "B")


class GainEditor:
    """Holds gains and their history; nothing here reaches a controller by itself.

    Args:
        robot_gains: The robot's own gains, to which "own" goes back.
        start: The gains to begin with; None for the robot's own.
        check: Raises Error where gains must not go; None allows all that is valid.
        now: The clock [s].

    Attributes:
        robot_gains: The robot's own gains.
        version: Counts every change.
        revision: Counts changes that a slider has not made, for sliders to follow.
        slots: Gains that were stored as A and as B.
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
        """The gains that are wanted, a copy."""
        return self._gains.__copy__()

    def get(self, name: str) -> float:
        """Return a gain's value."""
        return get_gain(self._gains, name)

    def set(self, name: str, value: float) -> None:
        """Change one gain; a slider's whole way counts as one change; raises Error."""
        gains = self.gains
        try:
            set_gain(gains, name, value)
            self._validate(gains)
        except Exception:
            self.revision += 1  # whatever shows the value has to go back
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
        """Change all gains at once; raises Error and changes nothing if one may not be."""
        self._validate(gains)
        self._save_history()
        self._set_gains(gains.__copy__())

    def undo(self) -> bool:
        """Go back by one change; return whether there was one."""
        if not self._history:
            return False
        self._set_gains(self._history.pop())
        return True

    def store(self, slot: str) -> None:
        """Keep the gains as A or B."""
        self.slots = {**self.slots, slot: self.gains}

    def use(self, slot: str) -> bool:
        """Take the gains kept as A or B; return whether there are any; raises Error."""
        if slot not in self.slots:
            return False
        self.replace(self.slots[slot])
        return True

    def changed(self) -> dict[str, tuple[float, float]]:
        """Return gains that differ from the robot's own: own value and present value by name."""
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
    """Return the gains whose values differ: first's and second's value by name."""
    changed = changed_gains(second, first)
    return {name: (get_gain(first, name), value) for name, value in changed.items()}
