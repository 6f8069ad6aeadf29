# SPDX-License-Identifier: BSD-3-Clause
"""Controllers for the tests of surefoot assess: one works, the others are faulty."""

from __future__ import annotations

import asyncio
import os
import threading
import time
from pathlib import Path

import numpy as np
import surefoot


def stand_controller(robot: surefoot.Robot):
    controller = surefoot.StandController(robot)
    return lambda state: controller.update(state)


def throws(robot: surefoot.Robot):
    def update(state):
        raise ValueError("no idea")

    return update


def fails_above_1_rad_s(robot: surefoot.Robot):
    controller = surefoot.StandController(robot)

    def update(state):
        if np.linalg.norm(state.imu.gyroscope) > 1.0:
            raise RuntimeError("too far")
        return controller.update(state)

    return update


def exits(robot: surefoot.Robot):
    def update(state):
        raise SystemExit(3)

    return update


def returns_nan(robot: surefoot.Robot):
    command = surefoot.LowCmd()
    command.motorCmd[3].tau = float("nan")
    return lambda state: command


def returns_infinity(robot: surefoot.Robot):
    command = surefoot.LowCmd()
    command.motorCmd[11].Kd = float("inf")
    return lambda state: command


def returns_wrong_shape(robot: surefoot.Robot):
    return lambda state: np.zeros(11)


def returns_none(robot: surefoot.Robot):
    return lambda state: None


def never_returns(robot: surefoot.Robot):
    def update(state):
        while True:
            time.sleep(0.05)

    return update


def kills_process(robot: surefoot.Robot):
    return lambda state: os._exit(7)


def dies_between_runs(robot: surefoot.Robot):
    """Return a controller that ends its process 0.3 s after its last command."""
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


def raises_cancelled(robot: surefoot.Robot):
    def update(state):
        raise asyncio.CancelledError

    return update


def factory_returns_dict(robot: surefoot.Robot):
    return {}


def factory_returns_int(robot: surefoot.Robot):
    return 5


def factory_raises(robot: surefoot.Robot):
    raise RuntimeError("cannot be made")


def zero_command(robot: surefoot.Robot):
    command = surefoot.LowCmd()
    return lambda state: command


def stalls_once(robot: surefoot.Robot):
    """Return a controller; the fourth one, counted by files in STALLS, never returns."""
    marks = Path(os.environ["STALLS"])
    runs = len(list(marks.iterdir()))
    (marks / str(runs)).touch()
    return never_returns(robot) if runs == 3 else zero_command(robot)


not_a_factory = 5
