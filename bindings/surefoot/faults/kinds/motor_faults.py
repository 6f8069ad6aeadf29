"""Faults of motors: how a motor executes its command, and what it reports."""

from __future__ import annotations

import numpy as np

from surefoot._core import LowCmd, LowState
from surefoot.faults.kinds.fault import Fault
from surefoot.faults.kinds.signals import signal_view
from surefoot.sim.hardware.motors import DAMPING_MODE

OVERHEATED_MODE = 8  # motor mode of an overheated motor in comm.h of the SDK


class WeakMotor(Fault):
    """A motor gives less torque than commanded, and reports the reduced torque as tauEst.

    Args:
        motor: Number of the motor.
        share: Share of the commanded torque that the motor gives.
    """

    def __init__(self, motor: int, share: float) -> None:
        self._motor, self._share = motor, share

    def change_command(self, command: LowCmd, k: int) -> None:
        """Scale torque, Kp and Kd in the command of the motor."""
        motor = command.motorCmd[self._motor]
        motor.tau, motor.Kp, motor.Kd = (
            self._share * value for value in (motor.tau, motor.Kp, motor.Kd)
        )


class DeadMotor(Fault):
    """A motor switches itself off.

    Args:
        motor: Number of the motor.
        mode: Reported motor mode. With mode 0x00 the motor brakes; with mode 0x08 (overheated) it
            turns freely.
        periods: Number of control periods until the motor works again.
    """

    def __init__(self, motor: int, mode: int, periods: int = 10**9) -> None:
        self._motor, self._mode, self._periods = motor, mode, periods

    def change_command(self, command: LowCmd, k: int) -> None:
        """Replace the command of the motor by braking or by no torque."""
        if k >= self._periods:
            return
        motor = command.motorCmd[self._motor]
        if self._mode == DAMPING_MODE:
            motor.mode = DAMPING_MODE
        else:
            motor.tau = motor.Kp = motor.Kd = 0.0

    def change_state(self, state: LowState, k: int) -> None:
        """Replace the motor mode in a sample; a motor that turns freely reports no torque."""
        if k < self._periods:
            motor = state.motorState[self._motor]
            motor.mode = self._mode
            motor.tauEst = motor.tauEst if self._mode == DAMPING_MODE else 0.0


class UnresponsiveMotors(Fault):
    """Motors keep the command that they received at the onset, and report no problem.

    Args:
        motors: Numbers of the motors.
    """

    def __init__(self, motors: list[int]) -> None:
        self._motors = motors
        self._held_command: LowCmd | None = None

    def change_command(self, command: LowCmd, k: int) -> None:
        """Replace the commands of the motors by their commands at the onset."""
        if self._held_command is None:
            self._held_command = LowCmd()
            self._held_command.raw[:] = command.raw
        for i in self._motors:
            held, motor = self._held_command.motorCmd[i], command.motorCmd[i]
            motor.q, motor.dq, motor.tau = held.q, held.dq, held.tau
            motor.Kp, motor.Kd = held.Kp, held.Kd


class SecondController(Fault):
    """A second controller holds the joints at the angles that they have at the onset.

    Args:
        every: The second controller overwrites one of `every` commands.
    """

    def __init__(self, every: int = 1) -> None:
        self._every = every
        self._q = np.zeros(12)

    def change_state(self, state: LowState, k: int) -> None:
        """Store the joint angles at the onset."""
        if k == 0:
            self._q = signal_view(state, "q").astype(float)

    def change_command(self, command: LowCmd, k: int) -> None:
        """Overwrite the command."""
        if k % self._every:
            return
        for i, q in enumerate(self._q):
            motor = command.motorCmd[i]
            # Kp [N.m/rad] and Kd [N.m.s/rad] are chosen, similar to the vendor's standing gains.
            motor.q, motor.dq, motor.tau, motor.Kp, motor.Kd = q, 0.0, 0.0, 60.0, 2.0
