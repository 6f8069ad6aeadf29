# SPDX-License-Identifier: BSD-3-Clause
"""Supervisors with one defect each, which the judge of the fault matrix must detect."""

from __future__ import annotations

import math
from collections.abc import Callable

import surefoot
from surefoot import Mode, RequestStatus

Change = Callable[[surefoot.LowCmd, "FaultySupervisor"], None]


class FaultySupervisor:
    """A supervisor whose commands are changed before they are sent.

    Attributes:
        ticks: Number of ticks so far.
        damping: Number of ticks since damping latched; 0 in other modes.
        not_ready: Number of ticks since arming checks failed; 0 while ready.
        torques: Last command sent in the modes RISE and STAND.
        accepts_all: True if every request is accepted.
    """

    def __init__(self, supervisor: surefoot.Supervisor, change: Change) -> None:
        self._supervisor, self._change = supervisor, change
        self.ticks = self.damping = self.not_ready = 0
        self.torques = surefoot.LowCmd()
        self.accepts_all = False

    def __getattr__(self, name: str) -> object:
        return getattr(self._supervisor, name)

    def request(self, mode: Mode) -> RequestStatus:
        return RequestStatus.ACCEPTED if self.accepts_all else self._supervisor.request(mode)

    def update(self, state: surefoot.LowState) -> surefoot.LowCmd:
        command = self._supervisor.update(state)
        self.ticks += 1
        self.damping = self.damping + 1 if self._supervisor.mode == Mode.DAMPING else 0
        self.not_ready = 0 if self._supervisor.arming.ready else self.not_ready + 1
        if self._supervisor.mode in (Mode.RISE, Mode.STAND):
            self.torques.raw[:] = command.raw
        self._change(command, self)
        return command


def sends_nan(command: surefoot.LowCmd, faulty: FaultySupervisor) -> None:
    if faulty.ticks % 1000 == 999:
        command.motorCmd[3].tau = math.nan


def keeps_torque(command: surefoot.LowCmd, faulty: FaultySupervisor) -> None:
    if faulty.damping:
        command.raw[:] = faulty.torques.raw


def damps_late(command: surefoot.LowCmd, faulty: FaultySupervisor) -> None:
    if 0 < faulty.damping < 15:
        command.raw[:] = faulty.torques.raw


def stops_damping(command: surefoot.LowCmd, faulty: FaultySupervisor) -> None:
    if faulty.damping:
        for i in range(12):
            command.motorCmd[i].Kd = 0.0


def resumes_torque(command: surefoot.LowCmd, faulty: FaultySupervisor) -> None:
    if faulty.damping == 100:
        command.raw[:] = faulty.torques.raw


def exceeds_torque_limit(command: surefoot.LowCmd, faulty: FaultySupervisor) -> None:
    if faulty.ticks == 400:
        command.motorCmd[4].tau = 24.0  # the limit of a go1's thigh is 23.7 N.m


def steps_torque(command: surefoot.LowCmd, faulty: FaultySupervisor) -> None:
    if faulty.ticks == 400:
        command.motorCmd[4].tau = 5.0


def sends_position(command: surefoot.LowCmd, faulty: FaultySupervisor) -> None:
    if faulty.ticks == 400:
        command.motorCmd[4].Kp, command.motorCmd[4].q = 1.0, 0.5


def always_damps(command: surefoot.LowCmd, faulty: FaultySupervisor) -> None:
    command.raw[:] = surefoot.damping_low_cmd(3.0).raw


def accepts_briefly(command: surefoot.LowCmd, faulty: FaultySupervisor) -> None:
    faulty.accepts_all = faulty.not_ready == 15  # for one tick, 30 ms after arming checks fail


STALE, HEALTHY = "stale_tick/stuck/standing", "healthy/off/lying"
FAULTY_SUPERVISORS: dict[str, tuple[Change, str, str]] = {
    "sends NaN": (sends_nan, "healthy/off/standing", "not finite"),
    "keeps its torques": (keeps_torque, STALE, "never damped"),
    "damps late": (damps_late, STALE, "damped after"),
    "sends zero gains instead of damping": (stops_damping, STALE, "never damped"),
    "resumes torques after latched damping": (resumes_torque, STALE, "torques again"),
    "exceeds the torque limit": (exceeds_torque_limit, HEALTHY, "torque 1.01 of the limit"),
    "steps a torque": (steps_torque, HEALTHY, "torque step"),
    "goes to position mode": (sends_position, HEALTHY, "position mode"),
    "accepts a request while not ready": (
        accepts_briefly,
        "nan_in_state/garbage/lying",
        "not refused after",
    ),
    "damps without a fault": (always_damps, "healthy/off/standing", "got no further"),
}
