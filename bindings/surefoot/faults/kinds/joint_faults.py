"""Faults of what a joint says: beyond its stop, or taking too much power."""

from __future__ import annotations

import math

from surefoot._core import LowState, Robot
from surefoot.faults.kinds.fault import Fault
from surefoot.robot.power_level import power_level

WATTS_PER_LEVEL = 100.0
KNEE_SPEED = 5.0  # [rad/s] of the knees whose power is too much


class JointOutsideLimits(Fault):
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

    def assumed_robot(self, robot: Robot) -> Robot:
        """Learn where the limit is."""
        config = robot.config
        lower, upper = config.q_lower[self._motor], config.q_upper[self._motor]
        self._q = lower - self._by if self._below else upper + self._by
        return robot

    def change_state(self, state: LowState, k: int) -> None:
        """Say so."""
        if k % self._every == 0:
            state.motorState[self._motor].q = self._q


class PowerOverload(Fault):
    """The four knees say that they take more power than the protection allows.

    Args:
        power_ratio: Of the level's power.
        every: In how many reports of so many ...
        length: ... they say so.
    """

    def __init__(self, power_ratio: float, every: int = 1, length: int = 1) -> None:
        self._power_ratio, self._every, self._length = power_ratio, every, length
        self._torque = 0.0

    def assumed_robot(self, robot: Robot) -> Robot:
        """Learn the level."""
        watts = self._power_ratio * WATTS_PER_LEVEL * power_level(robot.name)
        self._torque = watts / 4 / KNEE_SPEED
        return robot

    def change_state(self, state: LowState, k: int) -> None:
        """Say so."""
        if k % self._every < self._length:
            for motor in (2, 5, 8, 11):
                state.motorState[motor].dq = KNEE_SPEED
                state.motorState[motor].tauEst = self._torque
