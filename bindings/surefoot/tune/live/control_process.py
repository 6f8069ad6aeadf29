"""A StandRunner in a process of its own, so that no page and no browser may hold it up."""

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
    Mode,
    RunOptions,
    RunSnapshot,
    StandRunner,
)
from surefoot.geometry.rotations import Array
from surefoot.reports.damping_reason import damping_reason
from surefoot.robot.description import RobotDescription
from surefoot.robot.gain_files import gains_from_values
from surefoot.robot.loading import build_robot
from surefoot.tune.live.controller_metrics import body_reference
from surefoot.tune.live.metric_curves import TickMetrics

STATUS_PERIOD = 0.05  # [s] in which the runner says anew how it is
_FIRST_STATE_TIMEOUT = 1e6  # [s] a page may be opened long before the robot is switched on

Message = tuple[str, Any]
"""("gains", values by name), ("reference", values by axis), ("damp" | "rearm" | "stop", None)."""


@dataclass(frozen=True)
class RobotAddress:
    """Where a robot is and what it speaks.

    Attributes:
        host: Its address.
        port: Its UDP port.
        generation: Of its frames.
        power_level: Of the power protection, N x 100 W; 0 switches it off.
    """

    host: str
    port: int
    generation: str
    power_level: int = 1

    def __str__(self) -> str:
        return f"{self.host}:{self.port}"


@dataclass(frozen=True)
class RunnerStatus:
    """What the runner says of itself.

    Attributes:
        phase: A RunSnapshot's: "standing" where all is well.
        reason: Of the damping; while waiting, why what has come was not taken.
        q: (nq,) Pinocchio's, estimated; None before the robot has spoken.
        forces: (3, 4) that the program asks of the feet, world axes [N].
        contact: (4,) feet that are believed to bear.
        sample: Its numbers.
        refused: Re-arms that were refused so far, for no LowState came.
    """

    phase: str
    reason: str
    q: Array | None
    forces: Array
    contact: npt.NDArray[np.bool_]
    sample: TickMetrics
    refused: int = 0


def run_control_process(
    pipe: Connection, description: RobotDescription, place: RobotAddress, values: dict[str, float]
) -> None:
    """Control the robot until the pipe says "stop" or its other end is gone; ends by damping.

    The first message out is "" or what went wrong; Reports follow, as long as somebody reads them.
    """
    # The terminal's signals are the page's, which says stop; SIGTERM is anybody's.
    for number in (signal.SIGINT, signal.SIGHUP, signal.SIGTSTP):
        signal.signal(number, signal.SIG_IGN)
    try:
        runner = _make_runner(description, place, values)
    except Error as problem:
        pipe.send(str(problem))
        return
    signal.signal(signal.SIGTERM, lambda *_: runner.stop())
    loop = threading.Thread(target=runner.run)
    loop.start()
    try:
        pipe.send("")
        while loop.is_alive() and _handle_message(pipe, runner):
            _send_status(pipe, status_from_snapshot(runner.snapshot()))
    finally:
        runner.stop()  # what follows are damping frames
        loop.join()
        _send_status(pipe, status_from_snapshot(runner.snapshot()))


def status_from_snapshot(snapshot: RunSnapshot) -> RunnerStatus:
    """Return a snapshot as what goes through a pipe."""
    known = snapshot.ticks > 0
    power = snapshot.command_power
    reason = damping_reason(snapshot) if snapshot.phase in ("damping", "ended") else ""
    if snapshot.reason == "wrong_generation":
        reason = f"wrong generation: {snapshot.last_reject}"
    elif snapshot.phase == "waiting" and snapshot.link.received > 0:
        reason = snapshot.last_reject
    sample = (
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
        TickMetrics(*sample, snapshot.tick_p50) if known else TickMetrics(0.0, 0.0, 0.0, 0.0, 0.0),
        snapshot.refused_rearms,
    )


def _make_runner(
    description: RobotDescription, place: RobotAddress, values: dict[str, float]
) -> StandRunner:
    options = RunOptions(power_level=place.power_level, connect_timeout=_FIRST_STATE_TIMEOUT)
    endpoint = (place.host, place.port, place.generation)
    return StandRunner(
        build_robot(description), *endpoint, gains=gains_from_values(values), options=options
    )


def _handle_message(pipe: Connection, runner: StandRunner) -> bool:
    """Wait a moment for what the page asks for, and do it; return whether to go on."""
    try:
        if not pipe.poll(STATUS_PERIOD):
            return True
        word, values = pipe.recv()
    except (EOFError, OSError):  # the page is gone
        return False
    if word == "gains":
        runner.set_gains(gains_from_values(values))
    elif word == "reference":
        runner.set_body_reference(body_reference(values))
    elif word == "damp":
        runner.damp()
    elif word == "rearm":
        # One that a fault has made sit down is armed still.
        if runner.snapshot().mode == Mode.PASSIVE:
            runner.request(Mode.RISE)
        else:
            runner.rearm()
    return bool(word != "stop")


def _send_status(pipe: Connection, report: RunnerStatus) -> None:
    """Send a report if it can be sent at once: a page that hangs reads none."""
    if not select.select([], [pipe.fileno()], [], 0.0)[1]:
        return
    try:
        pipe.send(report)
    except OSError:  # the page is gone, as the next poll says too
        return
