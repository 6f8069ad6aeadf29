"""A RobotLoop in a process of its own, so that no page and no browser may hold it up."""

from __future__ import annotations

import signal
from multiprocessing.connection import Connection
from typing import Any

from surefoot._core import Error, Gains, gain_table, get_gain, set_gain
from surefoot.robot_files import RobotDescription
from surefoot.robots import build_robot
from surefoot.tune.live.measures import body_reference
from surefoot.tune.live.robot_loop import Place, RobotLoop
from surefoot.virtual_robot.clock import RealTime
from surefoot.virtual_robot.priority import RealTimePriority

PERIOD = 0.002  # [s]
REPORT_EVERY = 10  # periods
_FAREWELL = 50  # periods of damping frames at the end

Message = tuple[str, Any]
"""("gains", values by name), ("reference", values by axis), ("damp" | "rearm" | "stop", None)."""


def gain_values(gains: Gains) -> dict[str, float]:
    """Return gains as a dict, which goes through a pipe."""
    return {row.name: get_gain(gains, row.name) for row in gain_table()}


def control(
    pipe: Connection, description: RobotDescription, place: Place, values: dict[str, float]
) -> None:
    """Control the robot until the pipe says "stop" or its other end is gone; ends by damping.

    The first message out is "" or what went wrong; Reports follow.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the page's, which says stop
    try:
        loop = RobotLoop(build_robot(description), place, _gains_of(values))
    except Error as problem:
        pipe.send(str(problem))
        return
    pipe.send("")
    with RealTimePriority():
        clock = RealTime(PERIOD)
        while _obey(pipe, loop):
            clock.wait()
            loop.tick()
            if clock.cycles % REPORT_EVERY == 0 and not _send(pipe, loop):
                break
        for _ in range(_FAREWELL):
            loop.damp("asked")
            loop.tick()
            clock.wait()


def _gains_of(values: dict[str, float]) -> Gains:
    gains = Gains()
    for name, value in values.items():
        set_gain(gains, name, value)
    return gains


def _obey(pipe: Connection, loop: RobotLoop) -> bool:
    """Do what the page asks for; return whether to go on."""
    try:
        while pipe.poll():
            word, values = pipe.recv()
            if word == "stop":
                return False
            if word == "gains":
                loop.controller.set_gains(_gains_of(values))
            elif word == "reference":
                loop.controller.set_body_reference(body_reference(values))
            elif word == "damp":
                loop.damp("asked")
            else:
                loop.rearm()
    except (EOFError, OSError):
        return False
    return True


def _send(pipe: Connection, loop: RobotLoop) -> bool:
    try:
        pipe.send(loop.report())
    except OSError:  # the page is gone
        return False
    return True
