"""Recovery of a walking robot from pushes."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from surefoot.sim import Push
from surefoot.walk.heading_frame import attitude_on_ground, heading_velocity
from surefoot.walk.walk_log import WalkLog
from surefoot.walk.walk_motion import WalkMotion

# A robot has recovered when it follows its command again. Chosen: above the sway of a trot at 0.6
# m/s (0.05 m/s, 1 deg), and far below what a push of half the LIP push limit causes.
RECOVERED_SPEED = 0.15  # [m/s] tolerance of the horizontal velocity
RECOVERED_TILT = math.radians(5.0)  # [rad] tolerance of roll and of pitch


def recovered_ticks(log: WalkMotion) -> npt.NDArray[np.bool_]:
    """Return a mask (n,) of ticks at which velocity and attitude are as commanded."""
    speed_error = np.linalg.norm((heading_velocity(log) - log.commanded)[:, :2], axis=1)
    tilt = np.abs(attitude_on_ground(log)[:, :2]).max(axis=1)
    return np.asarray((speed_error < RECOVERED_SPEED) & (tilt < RECOVERED_TILT))


def recovery_times(log: WalkLog) -> list[float]:
    """Return the time [s] from the end of each push that ended until the robot has recovered.

    The time is limited to the next push, the next command, or the end of the log. A robot has
    recovered when it stays within the tolerances until then.
    """
    recovered = recovered_ticks(log)
    limits = [request.time for request in log.settings.velocities]
    limits += [push.time for push in log.pushes]
    times = []
    for push in log.pushes:
        end = _end_tick(push, log.rate)
        until = min((_tick(t, log.rate) for t in limits if _tick(t, log.rate) > end), default=None)
        away = np.flatnonzero(~recovered[end:until])
        if end < len(log):
            times.append((int(away[-1]) + 1 if len(away) else 0) / log.rate)
    return times


def _tick(time: float, rate: float) -> int:
    return round(time * rate)


def _end_tick(push: Push, rate: float) -> int:
    return _tick(push.time + push.duration, rate)
