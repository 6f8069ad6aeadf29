"""Faults of time: what LowState.tick says, and when the control loop comes to its turn."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from surefoot._core import LowCmd, LowState, Supervisor, damping_low_cmd
from surefoot.faults.kinds.fault import Fault
from surefoot.sim import Plant

WATCHDOG_PERIODS = 50  # [periods] after which a robot that is told nothing damps by itself


class TickFault(Fault):
    """The robot's clock says something else.

    Args:
        reported: What it says [ms] where it should say this, in the k-th period.
    """

    uses_frames = True

    def __init__(self, reported: Callable[[int, int], int]) -> None:
        self._reported = reported

    def change_state(self, state: LowState, k: int) -> None:
        """Change the tick."""
        state.tick = self._reported(state.tick, k) % 2**32


class TickOverflow(Fault):
    """The robot's clock overflows soon after the fault begins.

    Args:
        bits: Of the counter that does: 32, or 31 where it is read as signed.
    """

    uses_frames = True

    def __init__(self, bits: int) -> None:
        self._bits = bits

    def tick0(self, onset: int) -> int | None:
        """Return the tick that begins 100 ms before the overflow, less what passes until then."""
        return int((2**self._bits - 100 - onset) % 2**32)


class MissedPeriods(Fault):
    """The control loop does not come to its turn; the motors go on with the last command.

    Args:
        missed: Does it miss the k-th period?
    """

    def __init__(self, missed: Callable[[int], bool]) -> None:
        self._missed, self._missed_count = missed, 0

    def loop_runs(self, k: int) -> bool:
        """Return whether it runs."""
        self._missed_count = self._missed_count + 1 if self._missed(k) else 0
        return self._missed_count == 0

    def change_command(self, command: LowCmd, k: int) -> None:
        """Have the robot damp by itself after 100 ms without a command."""
        if self._missed_count > WATCHDOG_PERIODS:
            command.raw[:] = damping_low_cmd(3.0).raw


class ProgramSuspended(MissedPeriods):
    """The program stands still once; it is judged by what it does when it goes on.

    Args:
        periods: For so long.
    """

    def __init__(self, periods: int) -> None:
        super().__init__(lambda k: k < periods)
        self._remaining = periods

    def is_observable(self, plant: Plant) -> bool:
        """Return whether it goes on."""
        self._remaining -= 1
        return self._remaining < 0


class OperatorAction(Fault):
    """Somebody does something to the supervisor.

    Args:
        act: What, before the k-th tick.
    """

    def __init__(self, act: Callable[[Supervisor, int], object]) -> None:
        self._act = act

    def operate(self, supervisor: Supervisor, k: int) -> None:
        """Do it."""
        self._act(supervisor, k)


def random_periods(share: float) -> Callable[[int], bool]:
    """Return what is true by chance."""
    rng = np.random.default_rng(11)
    return lambda k: bool(rng.uniform() < share)


class FrozenTick(TickFault):
    """The tick stands still, whatever else is new."""

    def __init__(self) -> None:
        ticks: list[int] = []

        def reported(tick: int, k: int) -> int:
            ticks.append(tick)
            return ticks[0]

        super().__init__(reported)


def restarted_clock() -> Callable[[int, int], int]:
    """Return a clock that begins anew, period after period."""
    return lambda tick, k: 2 * k


def clock_at_speed(per_period: int) -> Callable[[int, int], int]:
    """Return a clock that goes on by so many milliseconds a period, from where it is."""
    ticks: list[int] = []

    def reported(tick: int, k: int) -> int:
        ticks.append(tick)
        return ticks[0] + per_period * k

    return reported
