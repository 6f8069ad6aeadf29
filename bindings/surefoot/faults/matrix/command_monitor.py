"""What every command is held against, whatever goes wrong: numbers, torque, rate, power, age."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from surefoot._core import LowCmd, LowState, Robot, Safety
from surefoot.faults.expectation import MAX_HOLD_TIME
from surefoot.messages.low_cmd_layout import LOW_CMD
from surefoot.messages.low_state_layout import MOTOR_COUNT

PERIOD = 0.002  # [s]
MAX_TORQUE_STEP = (
    0.1  # of a motor's torque limit, in one control period: 50 times the limit a second
)
_ROUNDING = 1e-6


def motors_of(command: LowCmd) -> npt.NDArray[Any]:
    """Return the twelve motors of a command as one array of fields; a view."""
    fields: npt.NDArray[Any] = command.raw.view(LOW_CMD)[0]["motorCmd"][:MOTOR_COUNT]
    return fields


def is_damping(command: LowCmd) -> bool:
    """Return whether all motors brake by themselves, and do nothing else."""
    motors = motors_of(command)
    brakes = (motors["Kd"] > 0) & (motors["dq"] == 0) & (motors["tau"] == 0) & (motors["Kp"] == 0)
    return bool(np.all(brakes & (motors["mode"] == 0x0A)))


class CommandMonitor:
    """Looks at every command that leaves.

    Rates are those of the command's own making: the change of tau, and of Kd at the speed that the
    joint has. Going over to the motors' own damping is at once by design and is not counted.

    Args:
        robot: For its limits.
        level: Of the power protection.

    Attributes:
        not_finite: Commands with a number that is none.
        torque_share: Greatest feed-forward torque, of its motor's limit.
        rate_share: Greatest change of torque in a period, of its motor's limit.
        power_trips: Commands with torques that left although the power protection refused them.
        power: Greatest power that was measured while torques were on [W].
        hold_time: Longest time for which the same torques were repeated [s].
        position_mode: Commands that ask a joint for a position.
    """

    def __init__(self, robot: Robot, level: int) -> None:
        self._safety, self._level = Safety(robot), level
        self._tau_max = np.array(robot.config.tau_max)
        self._previous: npt.NDArray[Any] | None = None
        self._repeats = 0
        self.not_finite = self.power_trips = self.position_mode = 0
        self.torque_share = self.rate_share = self.power = self.hold_time = 0.0

    def check(self, command: LowCmd, sample: LowState, dq: npt.NDArray[np.float64]) -> None:
        """Judge a command.

        Args:
            command: That leaves.
            sample: What the robot really measured, before anything damaged it.
            dq: (12,) true speeds of the motors [rad/s].
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
        # A motor that brakes at its limit makes no more than that, whatever its damping asks for.
        continued_torque = previous["tau"] + (motors["Kd"].astype(float) - previous["Kd"]) * dq
        step = motors["tau"] - np.clip(continued_torque, -self._tau_max, self._tau_max)
        self.rate_share = max(self.rate_share, float(np.max(np.abs(step) / self._tau_max)))

    def violations(self) -> list[str]:
        """Return what was not as it must be, in words."""
        found = []
        if self.not_finite:
            found.append(f"{self.not_finite} commands not finite")
        if self.torque_share > 1.0 + _ROUNDING:
            found.append(f"torque {self.torque_share:.2f} of the limit")
        if self.rate_share > MAX_TORQUE_STEP:
            found.append(f"torque step {self.rate_share:.2f} of the limit in a period")
        if self.power_trips:
            refused = f"{self.power_trips} commands that the power protection refused"
            found.append(f"{refused} ({self.power:.0f} W)")
        if self.position_mode:
            found.append(f"{self.position_mode} commands in position mode")
        if self.hold_time > MAX_HOLD_TIME + _ROUNDING:
            found.append(f"a command held for {1e3 * self.hold_time:.0f} ms")
        return found
