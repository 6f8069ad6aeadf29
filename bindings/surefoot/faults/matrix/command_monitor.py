"""Checks of every command during a fault: finite values, torque, torque rate, power, hold time."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from surefoot._core import LowCmd, LowState, Robot, Safety
from surefoot.faults.expectation import MAX_HOLD_TIME
from surefoot.messages.low_cmd_layout import LOW_CMD
from surefoot.messages.low_state_layout import MOTOR_COUNT

PERIOD = 0.002  # [s] control period of the SDK's examples; the default of PlantSettings
# Largest torque step per control period, as a share of the motor's torque limit: 1200 N.m/s on the
# hips of a go1. Chosen: similar to the limit of libfranka (1000 N.m/s). TorqueRateLimiter limits
# steps to 95 % of this value.
MAX_TORQUE_STEP = 0.1
_ROUNDING = 1e-6  # tolerance. Numerical: torques are floats, with a relative error of 1e-7


def motors_of(command: LowCmd) -> npt.NDArray[Any]:
    """Return a writable view of the fields of a command's twelve motors."""
    fields: npt.NDArray[Any] = command.raw.view(LOW_CMD)[0]["motorCmd"][:MOTOR_COUNT]
    return fields


def is_damping(command: LowCmd) -> bool:
    """Return True if a command has all motors damping, without torque and stiffness."""
    motors = motors_of(command)
    brakes = (motors["Kd"] > 0) & (motors["dq"] == 0) & (motors["tau"] == 0) & (motors["Kp"] == 0)
    return bool(np.all(brakes & (motors["mode"] == 0x0A)))


class CommandMonitor:
    """Monitor of every command that the supervisor sends.

    A torque step is the change of torque between two commands at the present joint velocity: the
    change of tau, and the change of Kd times the velocity. The switch to damping is immediate by
    design, so it does not count as a step.

    Args:
        robot: Model of the robot, for its limits.
        level: Power protection level.

    Attributes:
        not_finite: Number of commands with a NaN or an infinity.
        torque_share: Largest feed-forward torque, as a share of the motor's torque limit.
        torque_step_share: Largest torque step in a period, as a share of the motor's torque limit.
        power_trips: Number of commands, except damping, that the power protection refused.
        power: Largest measured power in periods without damping [W].
        hold_time: Longest time for which the same command was repeated [s].
        position_mode: Number of commands with Kp > 0.
    """

    def __init__(self, robot: Robot, level: int) -> None:
        self._safety, self._level = Safety(robot), level
        self._tau_max = np.array(robot.config.tau_max)
        self._previous: npt.NDArray[Any] | None = None
        self._repeats = 0
        self.not_finite = self.power_trips = self.position_mode = 0
        self.torque_share = self.torque_step_share = self.power = self.hold_time = 0.0

    def check(self, command: LowCmd, sample: LowState, dq: npt.NDArray[np.float64]) -> None:
        """Check a command and update the attributes.

        Args:
            command: Command that the supervisor sends.
            sample: LowState before the fault changed it.
            dq: (12,) true joint velocities of the motors [rad/s].
        """
        motors = motors_of(command).copy()
        fields = np.stack([motors[name] for name in ("q", "dq", "tau", "Kp", "Kd")]).astype(float)
        if not np.all(np.isfinite(fields)):
            self.not_finite += 1
            return
        is_damping_command = is_damping(command)
        self._check_power(command, sample, is_damping_command)
        self.torque_share = max(
            self.torque_share, float(np.max(np.abs(motors["tau"]) / self._tau_max))
        )
        self.position_mode += bool(np.any(motors["Kp"] > 0))
        if self._previous is not None:
            self._check_torque_step(motors, dq, is_damping_command)
        self._previous = motors

    def _check_power(self, command: LowCmd, sample: LowState, is_damping_command: bool) -> None:
        refused = self._safety.power_protect(command, sample, self._level) < 0
        if not is_damping_command:
            self.power = max(self.power, self._safety.power)
            self.power_trips += refused

    def _check_torque_step(
        self, motors: npt.NDArray[Any], dq: npt.NDArray[Any], is_damping_command: bool
    ) -> None:
        previous = self._previous
        assert previous is not None
        if is_damping_command:
            self._repeats = 0
            return
        same = bool(np.array_equal(motors, previous))
        self._repeats = self._repeats + 1 if same else 0
        self.hold_time = max(self.hold_time, self._repeats * PERIOD)
        # A motor limits its torque, so the torque of the last command is limited here too.
        continued_torque = previous["tau"] + (motors["Kd"].astype(float) - previous["Kd"]) * dq
        step = motors["tau"] - np.clip(continued_torque, -self._tau_max, self._tau_max)
        self.torque_step_share = max(
            self.torque_step_share, float(np.max(np.abs(step) / self._tau_max))
        )

    def violations(self) -> list[str]:
        """Return the violations of limits, each as text; empty if there are none."""
        found = []
        if self.not_finite:
            found.append(f"{self.not_finite} commands not finite")
        if self.torque_share > 1.0 + _ROUNDING:
            found.append(f"torque {self.torque_share:.2f} of the limit")
        if self.torque_step_share > MAX_TORQUE_STEP:
            found.append(f"torque step {self.torque_step_share:.2f} of the limit in a period")
        if self.power_trips:
            refused = f"{self.power_trips} commands that the power protection refused"
            found.append(f"{refused} ({self.power:.0f} W)")
        if self.position_mode:
            found.append(f"{self.position_mode} commands in position mode")
        if self.hold_time > MAX_HOLD_TIME + _ROUNDING:
            found.append(f"a command held for {1e3 * self.hold_time:.0f} ms")
        return found
