"""Faults of motors: what becomes of a command, and what the motor then says."""

from __future__ import annotations

import numpy as np

from surefoot._core import LowCmd, LowState
from surefoot.faults.kinds.fault import Fault
from surefoot.faults.kinds.signals import signal_view
from surefoot.sim.hardware.motors import DAMPING_MODE

OVERHEATED_MODE = 8


class WeakMotor(Fault):
    """A motor makes less torque than it is told to, and says so by tauEst.

    Args:
        motor: Its number.
        share: Of the torque that is left.
    """

    def __init__(self, motor: int, share: float) -> None:
        self._motor, self._share = motor, share

    def change_command(self, command: LowCmd, k: int) -> None:
        """Scale all that makes torque."""
        motor = command.motorCmd[self._motor]
        motor.tau, motor.Kp, motor.Kd = (
            self._share * value for value in (motor.tau, motor.Kp, motor.Kd)
        )


class DeadMotor(Fault):
    """A motor switches itself off.

    Args:
        motor: Its number.
        mode: That it reports; 0x00 brakes, 0x08 (overheated) lets go.
        periods: Until it is back.
    """

    def __init__(self, motor: int, mode: int, periods: int = 10**9) -> None:
        self._motor, self._mode, self._periods = motor, mode, periods

    def change_command(self, command: LowCmd, k: int) -> None:
        """Take the command away."""
        if k >= self._periods:
            return
        motor = command.motorCmd[self._motor]
        if self._mode == DAMPING_MODE:
            motor.mode = DAMPING_MODE
        else:
            motor.tau = motor.Kp = motor.Kd = 0.0

    def change_state(self, state: LowState, k: int) -> None:
        """Report the mode; a motor that has let go makes no torque."""
        if k < self._periods:
            motor = state.motorState[self._motor]
            motor.mode = self._mode
            motor.tauEst = motor.tauEst if self._mode == DAMPING_MODE else 0.0


class UnresponsiveMotors(Fault):
    """Motors go on with the command of the moment when it began, and say that all is well.

    Args:
        motors: Their numbers.
    """

    def __init__(self, motors: list[int]) -> None:
        self._motors = motors
        self._held_command: LowCmd | None = None

    def change_command(self, command: LowCmd, k: int) -> None:
        """Replace it."""
        if self._held_command is None:
            self._held_command = LowCmd()
            self._held_command.raw[:] = command.raw
        for i in self._motors:
            held, motor = self._held_command.motorCmd[i], command.motorCmd[i]
            motor.q, motor.dq, motor.tau = held.q, held.dq, held.tau
            motor.Kp, motor.Kd = held.Kp, held.Kd


class SecondController(Fault):
    """Another controller holds the robot's joints where they are.

    Args:
        every: It overwrites every so many'th command.
    """

    def __init__(self, every: int = 1) -> None:
        self._every = every
        self._q = np.zeros(12)

    def change_state(self, state: LowState, k: int) -> None:
        """See where they are."""
        if k == 0:
            self._q = signal_view(state, "q").astype(float)

    def change_command(self, command: LowCmd, k: int) -> None:
        """Overwrite the command."""
        if k % self._every:
            return
        for i, q in enumerate(self._q):
            motor = command.motorCmd[i]
            motor.q, motor.dq, motor.tau, motor.Kp, motor.Kd = q, 0.0, 0.0, 60.0, 2.0
