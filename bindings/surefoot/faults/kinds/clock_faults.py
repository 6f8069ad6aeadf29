"""Faults of time: wrong LowState.tick, missed periods of the control loop, operator actions."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from surefoot._core import LowCmd, LowState, Supervisor, damping_low_cmd
from surefoot.faults.kinds.fault import Fault
from surefoot.sim import Plant
from surefoot.sim.hardware.motors import BRAKE_KD

# Number of control periods without a command after which a robot damps by itself. Derived: 100 ms
# at 500 Hz, as kRobotWatchdogTime (controller/src/common/command_times.hpp) and the default timeout
# of the virtual robot.
WATCHDOG_PERIODS = 50


class TickFault(Fault):
    """The robot's clock reports wrong ticks.

    Args:
        reported: Function of the true tick [ms] and the period k that returns the reported tick
            [ms].
    """

    uses_frames = True

    def __init__(self, reported: Callable[[int, int], int]) -> None:
        self._reported = reported

    def change_state(self, state: LowState, k: int) -> None:
        """Replace the tick of a sample."""
        state.tick = self._reported(state.tick, k) % 2**32


class TickOverflow(Fault):
    """The robot's clock overflows soon after the fault begins.

    Args:
        bits: Number of bits after which the counter overflows. 32: the true size of the counter.
            31: the tick reaches 2^31, where a reader that stores it as a signed number fails.
    """

    uses_frames = True

    def __init__(self, bits: int) -> None:
        self._bits = bits

    def tick0(self, onset: int) -> int | None:
        """Return the first tick [ms] with which the clock overflows 100 ms after the onset."""
        return int((2**self._bits - 100 - onset) % 2**32)


class MissedPeriods(Fault):
    """The control loop misses periods, and the motors keep the last command.

    Args:
        missed: Function of the period k that returns True if the loop misses this period.
    """

    def __init__(self, missed: Callable[[int], bool]) -> None:
        self._missed, self._missed_count = missed, 0

    def loop_runs(self, k: int) -> bool:
        """Return True unless the loop misses period k."""
        self._missed_count = self._missed_count + 1 if self._missed(k) else 0
        return self._missed_count == 0

    def change_command(self, command: LowCmd, k: int) -> None:
        """Damp the motors after 100 ms without a command, as a robot does by itself."""
        if self._missed_count > WATCHDOG_PERIODS:
            command.raw[:] = damping_low_cmd(BRAKE_KD).raw


class ProcessSuspended(MissedPeriods):
    """The control process is suspended once; reaction times count from the end of the suspension.

    Args:
        periods: Duration of the suspension in control periods.
    """

    def __init__(self, periods: int) -> None:
        super().__init__(lambda k: k < periods)
        self._remaining = periods

    def is_observable(self, plant: Plant) -> bool:
        """Return True after the suspension."""
        self._remaining -= 1
        return self._remaining < 0


class OperatorAction(Fault):
    """An operator calls functions of the supervisor.

    Args:
        act: Function that is called with the supervisor and k before each tick k.
    """

    def __init__(self, act: Callable[[Supervisor, int], object]) -> None:
        self._act = act

    def operate(self, supervisor: Supervisor, k: int) -> None:
        """Perform the action of the operator."""
        self._act(supervisor, k)


def random_periods(share: float) -> Callable[[int], bool]:
    """Return a function of the period k that returns True with probability `share`."""
    rng = np.random.default_rng(11)  # any fixed seed, so that runs repeat
    return lambda k: bool(rng.uniform() < share)


class FrozenTick(TickFault):
    """The tick stays constant while all other data of the samples is new."""

    def __init__(self) -> None:
        ticks: list[int] = []

        def reported(tick: int, k: int) -> int:
            ticks.append(tick)
            return ticks[0]

        super().__init__(reported)


def restarted_clock() -> Callable[[int, int], int]:
    """Return a clock for TickFault that restarts at 0 and advances by 2 ms per period."""
    return lambda tick, k: 2 * k


def clock_with_step(ms_per_period: int) -> Callable[[int, int], int]:
    """Return a clock for TickFault that advances by `ms_per_period` ms in every period of 2 ms."""
    ticks: list[int] = []

    def reported(tick: int, k: int) -> int:
        ticks.append(tick)
        return ticks[0] + ms_per_period * k

    return reported
