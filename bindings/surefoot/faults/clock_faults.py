"""Faults of time: what LowState.tick says, and when the control loop comes to its turn."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from surefoot._core import LowCmd, LowState, Supervisor, damping_low_cmd
from surefoot.faults.fault import Fault
from surefoot.sim import Plant

WATCHDOG = 50  # [periods] after which a robot that is told nothing damps by itself


class Tick(Fault):
    """The robot's clock says something else.

    Args:
        said: What it says [ms] where it should say this, in the k-th period.
    """

    linked = True

    def __init__(self, said: Callable[[int, int], int]) -> None:
        self._said = said

    def state(self, state: LowState, k: int) -> None:
        """Change the tick."""
        state.tick = self._said(state.tick, k) % 2**32


class Wrap(Fault):
    """The robot's clock overflows soon after the fault begins.

    Args:
        bits: Of the counter that does: 32, or 31 where it is read as signed.
    """

    linked = True

    def __init__(self, bits: int) -> None:
        self._bits = bits

    def tick0(self, onset: int) -> int | None:
        """Return the tick that begins 100 ms before the overflow, less what passes until then."""
        return int((2**self._bits - 100 - onset) % 2**32)


class Missed(Fault):
    """The control loop does not come to its turn; the motors go on with the last command.

    Args:
        missed: Does it miss the k-th period?
    """

    def __init__(self, missed: Callable[[int], bool]) -> None:
        self._missed, self._silent = missed, 0

    def runs(self, k: int) -> bool:
        """Return whether it runs."""
        self._silent = self._silent + 1 if self._missed(k) else 0
        return self._silent == 0

    def command(self, command: LowCmd, k: int) -> None:
        """Have the robot damp by itself after 100 ms without a command."""
        if self._silent > WATCHDOG:
            command.raw[:] = damping_low_cmd(3.0).raw


class Suspended(Missed):
    """The program stands still once; it is judged by what it does when it goes on.

    Args:
        periods: For so long.
    """

    def __init__(self, periods: int) -> None:
        super().__init__(lambda k: k < periods)
        self._left = periods

    def judged(self, plant: Plant) -> bool:
        """Return whether it goes on."""
        self._left -= 1
        return self._left < 0


class Operator(Fault):
    """Somebody does something to the supervisor.

    Args:
        act: What, before the k-th tick.
    """

    def __init__(self, act: Callable[[Supervisor, int], object]) -> None:
        self._act = act

    def operate(self, supervisor: Supervisor, k: int) -> None:
        """Do it."""
        self._act(supervisor, k)


def dice(share: float) -> Callable[[int], bool]:
    """Return what is true by chance."""
    rng = np.random.default_rng(11)
    return lambda k: bool(rng.uniform() < share)


class Frozen(Tick):
    """The tick stands still, whatever else is new."""

    def __init__(self) -> None:
        kept: list[int] = []

        def said(tick: int, k: int) -> int:
            kept.append(tick)
            return kept[0]

        super().__init__(said)


def restarted() -> Callable[[int, int], int]:
    """Return a clock that begins anew, period after period."""
    return lambda tick, k: 2 * k


def at_speed(per_period: int) -> Callable[[int, int], int]:
    """Return a clock that goes on by so many milliseconds a period, from where it is."""
    kept: list[int] = []

    def said(tick: int, k: int) -> int:
        kept.append(tick)
        return kept[0] + per_period * k

    return said
