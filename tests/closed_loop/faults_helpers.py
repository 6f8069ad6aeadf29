# SPDX-License-Identifier: BSD-3-Clause
"""Supervisors that do one thing wrong, for the judge of the fault matrix to see."""

from __future__ import annotations

import math
from collections.abc import Callable

import surefoot
from surefoot import Mode, RequestStatus

Change = Callable[[surefoot.LowCmd, "Forged"], None]


class Forged:
    """A supervisor whose commands are changed on their way out.

    Attributes:
        ticks: So far.
        damping: Ticks since it latched.
        unready: Ticks since arming checks failed.
        torques: The last command that was not damping.
        yields: Whether it says yes to every request.
    """

    def __init__(self, supervisor: surefoot.Supervisor, change: Change) -> None:
        self._supervisor, self._change = supervisor, change
        self.ticks = self.damping = self.unready = 0
        self.torques = surefoot.LowCmd()
        self.yields = False

    def __getattr__(self, name: str) -> object:
        return getattr(self._supervisor, name)

    def request(self, mode: Mode) -> RequestStatus:
        return RequestStatus.ACCEPTED if self.yields else self._supervisor.request(mode)

    def update(self, state: surefoot.LowState) -> surefoot.LowCmd:
        command = self._supervisor.update(state)
        self.ticks += 1
        self.damping = self.damping + 1 if self._supervisor.mode == Mode.DAMPING else 0
        self.unready = 0 if self._supervisor.arming.ready else self.unready + 1
        if self._supervisor.mode in (Mode.RISE, Mode.STAND):
            self.torques.raw[:] = command.raw
        self._change(command, self)
        return command


def no_number(command: surefoot.LowCmd, forged: Forged) -> None:
    if forged.ticks % 1000 == 999:
        command.motorCmd[3].tau = math.nan


def keeps_torques(command: surefoot.LowCmd, forged: Forged) -> None:
    if forged.damping:
        command.raw[:] = forged.torques.raw


def late(command: surefoot.LowCmd, forged: Forged) -> None:
    if 0 < forged.damping < 15:
        command.raw[:] = forged.torques.raw


def lets_go(command: surefoot.LowCmd, forged: Forged) -> None:
    if forged.damping:
        for i in range(12):
            command.motorCmd[i].Kd = 0.0


def comes_back(command: surefoot.LowCmd, forged: Forged) -> None:
    if forged.damping == 100:
        command.raw[:] = forged.torques.raw


def too_strong(command: surefoot.LowCmd, forged: Forged) -> None:
    if forged.ticks == 400:
        command.motorCmd[4].tau = 24.0  # of 23.7 that a go1's thigh has


def jumps(command: surefoot.LowCmd, forged: Forged) -> None:
    if forged.ticks == 400:
        command.motorCmd[4].tau = 5.0


def servo(command: surefoot.LowCmd, forged: Forged) -> None:
    if forged.ticks == 400:
        command.motorCmd[4].Kp, command.motorCmd[4].q = 1.0, 0.5


def lies(command: surefoot.LowCmd, forged: Forged) -> None:
    command.raw[:] = surefoot.damping_low_cmd(3.0).raw


def gives_in(command: surefoot.LowCmd, forged: Forged) -> None:
    forged.yields = forged.unready == 15  # for one period, some 30 ms after the fault


STALE, WELL = "stale_tick/stuck/standing", "healthy/off/lying"
FORGERIES: dict[str, tuple[Change, str, str]] = {
    "sends no numbers": (no_number, "healthy/off/standing", "not finite"),
    "keeps its torques": (keeps_torques, STALE, "never damped"),
    "is late": (late, STALE, "damped after"),
    "lets go instead of damping": (lets_go, STALE, "never damped"),
    "comes back from latched damping": (comes_back, STALE, "torques again"),
    "asks for too much torque": (too_strong, WELL, "torque 1.01 of the limit"),
    "jumps": (jumps, WELL, "torque step"),
    "goes to position mode": (servo, WELL, "position mode"),
    "gives in for a moment": (gives_in, "nan_in_state/garbage/lying", "not refused after"),
    "damps though nothing is wrong": (lies, "healthy/off/standing", "got no further"),
}
