"""Faults of measurements: joint angles beyond a limit, power above the level of the protection."""

from __future__ import annotations

import math

from surefoot._core import LowState, Robot, SupervisorOptions
from surefoot.faults.kinds.fault import Fault

WATTS_PER_LEVEL = 100.0  # [W] per level of the SDK's PowerProtect; Safety::kWattsPerLevel
# [rad/s] Reported speed of the calf motors. Chosen: below the speed limits of the motors (15 rad/s
# and more). At a lower speed, the same power would need torques beyond the plausible range of a
# LowState.
CALF_SPEED = 5.0


class JointOutsideLimits(Fault):
    """A joint reports an angle outside its limits.

    Args:
        by: Distance of the reported angle beyond the limit [rad].
        motor: Number of the motor.
        below: True: beyond the lower limit. False: beyond the upper limit.
        every: The fault is in one of `every` samples.
    """

    def __init__(self, by: float, motor: int, below: bool, every: int = 1) -> None:
        self._by, self._motor, self._below, self._every = by, motor, below, every
        self._q = math.nan

    def assumed_robot(self, robot: Robot) -> Robot:
        """Compute the reported angle from the joint limits; return the model unchanged."""
        config = robot.config
        lower, upper = config.q_lower[self._motor], config.q_upper[self._motor]
        self._q = lower - self._by if self._below else upper + self._by
        return robot

    def change_state(self, state: LowState, k: int) -> None:
        """Replace the joint angle in a sample."""
        if k % self._every == 0:
            state.motorState[self._motor].q = self._q


class PowerOverload(Fault):
    """The four calf motors report more power than the power protection allows.

    Args:
        power_ratio: Ratio of the reported power to the power at which the protection trips.
        every: Number of samples in a cycle.
        length: Number of samples at the start of each cycle that report the overload.
    """

    def __init__(self, power_ratio: float, every: int = 1, length: int = 1) -> None:
        self._power_ratio, self._every, self._length = power_ratio, every, length
        self._torque = 0.0

    def set_options(self, options: SupervisorOptions) -> None:
        """Compute the reported torque from the power level; leave the options unchanged."""
        watts = self._power_ratio * WATTS_PER_LEVEL * options.power_level
        self._torque = watts / 4 / CALF_SPEED

    def change_state(self, state: LowState, k: int) -> None:
        """Replace speed and torque of the four calf motors in a sample."""
        if k % self._every < self._length:
            for motor in (2, 5, 8, 11):
                state.motorState[motor].dq = CALF_SPEED
                state.motorState[motor].tauEst = self._torque
