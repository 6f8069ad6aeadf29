"""What every command is held against, whatever goes wrong: numbers, torque, rate, power, age."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from surefoot._core import LowCmd, LowState, Robot, Safety
from surefoot.faults.reaction import HOLD
from surefoot.low_cmd_layout import LOW_CMD
from surefoot.low_state_layout import MOTORS

PERIOD = 0.002  # [s]
RATE_SHARE = 0.1  # of a motor's torque limit, in one control period: 50 times the limit a second
_ROUNDING = 1e-6


def motors_of(command: LowCmd) -> npt.NDArray[Any]:
    """Return the twelve motors of a command as one array of fields; a view."""
    motors: npt.NDArray[Any] = command.raw.view(LOW_CMD)[0]["motorCmd"][:MOTORS]
    return motors


def is_damping(command: LowCmd) -> bool:
    """Return whether all motors brake by themselves, and do nothing else."""
    m = motors_of(command)
    brakes = (m["Kd"] > 0) & (m["dq"] == 0) & (m["tau"] == 0) & (m["Kp"] == 0)
    return bool(np.all(brakes & (m["mode"] == 0x0A)))


class CommandJudge:
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
        held: Longest time for which the same torques were repeated [s].
        position_mode: Commands that ask a joint for a position.
    """

    def __init__(self, robot: Robot, level: int) -> None:
        self._safety, self._level = Safety(robot), level
        self._tau_max = np.array(robot.config.tau_max)
        self._before: npt.NDArray[Any] | None = None
        self._repeats = 0
        self.not_finite = self.power_trips = self.position_mode = 0
        self.torque_share = self.rate_share = self.power = self.held = 0.0

    def look(self, command: LowCmd, report: LowState, dq: npt.NDArray[np.float64]) -> None:
        """Judge a command.

        Args:
            command: That leaves.
            report: What the robot really measured, before anything damaged it.
            dq: (12,) true speeds of the motors [rad/s].
        """
        m = motors_of(command).copy()
        fields = np.stack([m[name] for name in ("q", "dq", "tau", "Kp", "Kd")]).astype(float)
        if not np.all(np.isfinite(fields)):
            self.not_finite += 1
            return
        damps = is_damping(command)
        self._look_at_power(command, report, damps)
        self.torque_share = max(self.torque_share, float(np.max(np.abs(m["tau"]) / self._tau_max)))
        self.position_mode += bool(np.any(m["Kp"] > 0))
        if self._before is not None:
            self._look_at_step(m, dq, damps)
        self._before = m

    def _look_at_power(self, command: LowCmd, report: LowState, damps: bool) -> None:
        refused = self._safety.power_protect(command, report, self._level) < 0
        if not damps:
            self.power = max(self.power, self._safety.power)
            self.power_trips += refused

    def _look_at_step(self, m: npt.NDArray[Any], dq: npt.NDArray[Any], damps: bool) -> None:
        before = self._before
        assert before is not None
        if damps:
            self._repeats = 0
            return
        same = bool(np.array_equal(m, before))
        self._repeats = self._repeats + 1 if same else 0
        self.held = max(self.held, self._repeats * PERIOD)
        # A motor that brakes at its limit makes no more than that, whatever its damping asks for.
        goes_on = before["tau"] + (m["Kd"].astype(float) - before["Kd"]) * dq
        step = m["tau"] - np.clip(goes_on, -self._tau_max, self._tau_max)
        self.rate_share = max(self.rate_share, float(np.max(np.abs(step) / self._tau_max)))

    def violations(self) -> list[str]:
        """Return what was not as it must be, in words."""
        found = []
        if self.not_finite:
            found.append(f"{self.not_finite} commands not finite")
        if self.torque_share > 1.0 + _ROUNDING:
            found.append(f"torque {self.torque_share:.2f} of the limit")
        if self.rate_share > RATE_SHARE:
            found.append(f"torque step {self.rate_share:.2f} of the limit in a period")
        if self.power_trips:
            refused = f"{self.power_trips} commands that the power protection refused"
            found.append(f"{refused} ({self.power:.0f} W)")
        if self.position_mode:
            found.append(f"{self.position_mode} commands in position mode")
        if self.held > HOLD + _ROUNDING:
            found.append(f"a command held for {1e3 * self.held:.0f} ms")
        return found
