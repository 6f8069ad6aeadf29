"""Control process: runs a Runner in its own process, so that the page cannot delay it."""

from __future__ import annotations

import select
import signal
import threading
from dataclasses import dataclass
from multiprocessing.connection import Connection
from typing import Any

import numpy as np
import numpy.typing as npt

from surefoot._core import (
    Error,
    Gait,
    Mode,
    Runner,
    RunOptions,
    RunSnapshot,
    WalkLimit,
    WalkVelocity,
)
from surefoot.geometry.rotations import Array
from surefoot.reports.damping_reason import damping_reason
from surefoot.reports.refusal_reason import refusal_reason
from surefoot.robot.description import RobotDescription
from surefoot.robot.gain_files import gains_from_values
from surefoot.robot.loading import build_robot
from surefoot.tune.live.controller_metrics import body_reference
from surefoot.tune.live.metric_curves import TickMetrics

# Derived: the period of published snapshots (kPublishPeriod in runner.cpp).
STATUS_PERIOD = 0.05  # [s] time between two RunnerStatus messages
_FIRST_STATE_TIMEOUT = 1e6  # [s] no limit: the robot may be switched on long after the page

Message = tuple[str, Any]
"""Message from the page: ("gains", values by name), ("reference", values by axis),
("velocity", (vx, vy [m/s], yaw rate [rad/s])), ("gait", name), ("walk", None), ("stand", None),
("damp", None), ("rearm", None) or ("stop", None)."""


@dataclass(frozen=True)
class RobotAddress:
    """Address of a robot, and the settings of its link.

    Attributes:
        host: Address of the robot.
        port: UDP port of the robot.
        generation: SDK generation of the robot's frames.
        power_level: Level of the power protection, in units of 100 W; 0: no power protection.
    """

    host: str
    port: int
    generation: str
    power_level: int = 1

    def __str__(self) -> str:
        return f"{self.host}:{self.port}"


@dataclass(frozen=True)
class RunnerStatus:
    """Status of the runner, sent to the page.

    Attributes:
        phase: Phase of the RunSnapshot; "standing" or "walking" in normal operation.
        reason: Why the robot damps. Before the first LowState: why the last datagram was rejected.
        q: Estimated q, (nq,), Pinocchio's order; None before the first LowState.
        forces: Contact forces of the QP, (3, 4), world axes [N].
        contact: (4,) true for each foot with a contact confidence above 0.5.
        metrics: Metrics of the last tick; their tick_us is the median of the tick times.
        refused: Number of re-arms that were refused because no LowState arrived or an arming check
            failed.
        walk: Commanded velocity, gait and limit as text; "" while the robot does not walk.
        refusal: Why the last request to walk or to stand was refused; "" if it was accepted.
    """

    phase: str
    reason: str
    q: Array | None
    forces: Array
    contact: npt.NDArray[np.bool_]
    metrics: TickMetrics
    refused: int = 0
    walk: str = ""
    refusal: str = ""


def run_control_process(
    pipe: Connection, description: RobotDescription, address: RobotAddress, values: dict[str, float]
) -> None:
    """Control the robot until the message "stop" or until the pipe closes; then damp and end.

    The first message to the page is "" if the runner was made, otherwise an error text. Then
    RunnerStatus messages follow; they are dropped while the page does not read.

    Args:
        pipe: Connection to the page.
        description: The robot's files.
        address: Address of the robot.
        values: Initial gains by name.
    """
    # Ignore the terminal's signals: the page handles them and sends "stop". SIGTERM stops this
    # process.
    for number in (signal.SIGINT, signal.SIGHUP, signal.SIGTSTP):
        signal.signal(number, signal.SIG_IGN)
    try:
        runner = _make_runner(description, address, values)
    except Error as problem:
        pipe.send(str(problem))
        return
    signal.signal(signal.SIGTERM, lambda *_: runner.stop())
    messages = _Messages(pipe, runner)
    loop = threading.Thread(target=runner.run)
    loop.start()
    try:
        pipe.send("")
        while loop.is_alive() and messages.handle():
            _send_status(pipe, status_from_snapshot(runner.snapshot(), messages.refusal))
    finally:
        runner.stop()  # sends damping commands
        loop.join()
        _send_status(pipe, status_from_snapshot(runner.snapshot()))


def status_from_snapshot(snapshot: RunSnapshot, refusal: str = "") -> RunnerStatus:
    """Convert a snapshot, and why a request was refused, to the message for the page."""
    known = snapshot.ticks > 0
    power = snapshot.command_power
    reason = damping_reason(snapshot) if snapshot.phase in ("damping", "ended") else ""
    if snapshot.reason == "wrong_generation":
        reason = f"wrong generation: {snapshot.last_reject}"
    elif snapshot.phase == "waiting" and snapshot.link.received > 0:
        reason = snapshot.last_reject
    metrics = (
        1000.0 * snapshot.position_error,
        float(np.degrees(snapshot.orientation_error)),
        snapshot.torque_ratio,
        power,
    )
    return RunnerStatus(
        snapshot.phase,
        reason,
        np.array(snapshot.q) if known else None,
        np.array(snapshot.desired_forces).reshape(4, 3).T,
        np.array(snapshot.contact) > 0.5,
        TickMetrics(*metrics, snapshot.tick_p50) if known else TickMetrics(0.0, 0.0, 0.0, 0.0, 0.0),
        snapshot.refused_rearms,
        walk_text(snapshot) if snapshot.phase == "walking" else "",
        refusal,
    )


def walk_text(snapshot: RunSnapshot) -> str:
    """Return commanded velocity, gait and limit of a walking robot as text."""
    v, limit = snapshot.commanded_velocity, snapshot.velocity_limit
    limited = "" if limit == WalkLimit.NONE else f", limit: {limit.name.lower()}"
    stopping = ", stopping" if snapshot.stopping else ""
    return (
        f"Command {v.vx:.2f}, {v.vy:.2f} m/s, {v.yaw_rate:.2f} rad/s{limited}, "
        f"gait {snapshot.gait.name.lower()}{stopping}"
    )


def _make_runner(
    description: RobotDescription, address: RobotAddress, values: dict[str, float]
) -> Runner:
    options = RunOptions(power_level=address.power_level, connect_timeout=_FIRST_STATE_TIMEOUT)
    endpoint = (address.host, address.port, address.generation)
    return Runner(
        build_robot(description), *endpoint, gains=gains_from_values(values), options=options
    )


class _Messages:
    """Handler of the messages from the page.

    Args:
        pipe: Connection to the page.
        runner: Receives the requests.

    Attributes:
        refusal: See RunnerStatus.
    """

    def __init__(self, pipe: Connection, runner: Runner) -> None:
        self._pipe, self._runner = pipe, runner
        self.refusal = ""

    def handle(self) -> bool:
        """Wait up to STATUS_PERIOD for a message and handle it.

        Return False after the message "stop", or if the page has ended.
        """
        try:
            if not self._pipe.poll(STATUS_PERIOD):
                return True
            word, values = self._pipe.recv()
        except (EOFError, OSError):  # the page has ended
            return False
        runner = self._runner
        if word == "gains":
            runner.set_gains(gains_from_values(values))
        elif word == "reference":
            runner.set_body_reference(body_reference(values))
        elif word == "velocity":
            runner.set_velocity(WalkVelocity(*values))
        elif word == "gait":
            runner.set_gait(Gait[values])
        elif word in ("walk", "stand"):
            self._request(Mode.WALK if word == "walk" else Mode.STAND)
        elif word == "damp":
            runner.damp()
        elif word == "rearm":
            self._rearm()
        return bool(word != "stop")

    def _request(self, mode: Mode) -> None:
        why = refusal_reason(self._runner.request(mode), self._runner.snapshot())
        self.refusal = f"{mode.name.lower()} refused: {why}" if why else ""

    def _rearm(self) -> None:
        self.refusal = ""
        # A robot that sat down after a fault is still armed and only needs to rise.
        if self._runner.snapshot().mode == Mode.PASSIVE:
            self._runner.request(Mode.RISE)
        else:
            self._runner.rearm()


def _send_status(pipe: Connection, status: RunnerStatus) -> None:
    """Send a status only if the pipe accepts it at once.

    A page that hangs would otherwise block this process.
    """
    if not select.select([], [pipe.fileno()], [], 0.0)[1]:
        return
    try:
        pipe.send(status)
    except OSError:  # the page has ended; the next poll detects it too
        return
