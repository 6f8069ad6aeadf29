"""Faults of what a joint says: beyond its stop, or taking too much power."""

from __future__ import annotations

import math

from surefoot._core import LowState, Robot
from surefoot.faults.fault import Fault

WATTS_PER_LEVEL = 100.0
LEVELS = {"b1": 10}  # of the power protection; 1 for all others
SPEED = 5.0  # [rad/s] of the knees whose power is too much


def power_level(robot: str) -> int:
    """Return the level of the power protection that a robot is run with."""
    return LEVELS.get(robot, 1)


class Outside(Fault):
    """A joint says that it is outside its limits.

    Args:
        by: How far [rad].
        motor: Its number.
        below: The lower limit's.
        every: In one report of so many.
    """

    def __init__(self, by: float, motor: int, below: bool, every: int = 1) -> None:
        self._by, self._motor, self._below, self._every = by, motor, below, every
        self._q = math.nan

    def robot(self, robot: Robot) -> Robot:
        """Learn where the limit is."""
        config = robot.config
        lower, upper = config.q_lower[self._motor], config.q_upper[self._motor]
        self._q = lower - self._by if self._below else upper + self._by
        return robot

    def state(self, state: LowState, k: int) -> None:
        """Say so."""
        if k % self._every == 0:
            state.motorState[self._motor].q = self._q


class Power(Fault):
    """The four knees say that they take more power than the protection allows.

    Args:
        share: Of the level's power.
        every: In how many reports of so many ...
        length: ... they say so.
    """

    def __init__(self, share: float, every: int = 1, length: int = 1) -> None:
        self._share, self._every, self._length = share, every, length
        self._torque = 0.0

    def robot(self, robot: Robot) -> Robot:
        """Learn the level."""
        watts = self._share * WATTS_PER_LEVEL * power_level(robot.name)
        self._torque = watts / 4 / SPEED
        return robot

    def state(self, state: LowState, k: int) -> None:
        """Say so."""
        if k % self._every < self._length:
            for motor in (2, 5, 8, 11):
                state.motorState[motor].dq = SPEED
                state.motorState[motor].tauEst = self._torque
