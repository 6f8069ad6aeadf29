# SPDX-License-Identifier: BSD-3-Clause
"""Controllers for the assessment: one that is good, and every way to be none."""

from __future__ import annotations

import asyncio
import os
import threading
import time
from pathlib import Path

import numpy as np
import surefoot


def good(robot: surefoot.Robot):
    controller = surefoot.StandController(robot)
    return lambda state: controller.update(state)


def throws(robot: surefoot.Robot):
    def update(state):
        raise ValueError("no idea")

    return update


def gives_up(robot: surefoot.Robot):
    controller = surefoot.StandController(robot)

    def update(state):
        if np.linalg.norm(state.imu.gyroscope) > 1.0:
            raise RuntimeError("too far")
        return controller.update(state)

    return update


def leaves(robot: surefoot.Robot):
    def update(state):
        raise SystemExit(3)

    return update


def nan(robot: surefoot.Robot):
    command = surefoot.LowCmd()
    command.motorCmd[3].tau = float("nan")
    return lambda state: command


def infinite(robot: surefoot.Robot):
    command = surefoot.LowCmd()
    command.motorCmd[11].Kd = float("inf")
    return lambda state: command


def wrong_shape(robot: surefoot.Robot):
    return lambda state: np.zeros(11)


def nothing(robot: surefoot.Robot):
    return lambda state: None


def never(robot: surefoot.Robot):
    def update(state):
        while True:
            time.sleep(0.05)

    return update


def dies(robot: surefoot.Robot):
    return lambda state: os._exit(7)


def dies_idle(robot: surefoot.Robot):
    """Holds still, and ends its process a while after its last update."""
    called = [0.0]

    def watch():
        while time.monotonic() < called[0] + 0.3:
            time.sleep(0.01)
        os._exit(7)

    def update(state):
        first, called[0] = not called[0], time.monotonic()
        if first:
            threading.Thread(target=watch, daemon=True).start()
        return surefoot.LowCmd()

    return update


def cancels(robot: surefoot.Robot):
    def update(state):
        raise asyncio.CancelledError

    return update


def mapping(robot: surefoot.Robot):
    return {}


def not_callable(robot: surefoot.Robot):
    return 5


def no_factory(robot: surefoot.Robot):
    raise RuntimeError("cannot be made")


def limp(robot: surefoot.Robot):
    command = surefoot.LowCmd()
    return lambda state: command


def stalls_once(robot: surefoot.Robot):
    """Stands still for ever in the first run after some that went well, and never again."""
    marks = Path(os.environ["STALLS"])
    runs = len(list(marks.iterdir()))
    (marks / str(runs)).touch()
    return never(robot) if runs == 3 else limp(robot)


number = 5
