"""Figures of estimators that start wrong."""

from __future__ import annotations

import math

import numpy as np
from surefoot import Robot

from estimation.errors import Errors, compare
from estimation.figures import Result
from estimation.log_rows import Array, Log
from estimation.recording import cut, rate_of
from estimation.replay import replay
from estimation.rows import pushes, rows_of, speed

SPEED_GONE, TILT_GONE = 0.05, math.radians(1.0)  # [m/s], [rad] of an error that is gone
WRONG_TILT = math.radians(30.0)


def init(robot: Robot, logs: dict[str, Log], seed: int) -> Result:
    """Time until the error of a wrong start is gone: a tilted quaternion, a base in motion."""
    still, shoved = logs["quiet"], logs["shove"]
    tilted = cut(still, slice(0, rows_of(still, 5.0)))
    tilted["quaternion"] = tilt_quaternions(tilted["quaternion"], seed)
    times, speeds = [], []
    for begin, end in _flights(shoved):
        log = cut(shoved, slice(begin, end))
        times.append(time_until_gone(log, compare(log, replay(robot, log))))
        speeds.append(float(speed(log)[0]))
    return Result(
        {
            "fell": float(shoved["fell"]),
            "tilted quaternion": time_until_gone(tilted, compare(tilted, replay(robot, tilted))),
            "moving start": max(times, default=math.nan),
            "speed at start": max(speeds, default=math.nan),
        }
    )


def _flights(log: Log) -> list[tuple[int, int]]:
    """Return (first, end) of pieces of 1.5 s that begin when a push has made the base fastest.

    They end before the next push, whose blow is an error of its own.
    """
    window, length = rows_of(log, 0.3), rows_of(log, 1.5)
    begins = [start + int(np.argmax(speed(log)[start : start + window])) for start in pushes(log)]
    return [(begin, begin + length) for begin in begins]


def time_until_gone(log: Log, errors: Errors) -> float:
    """Return the time [s] from which on velocity and tilt, beyond the bias's part, are right."""
    wrong = np.linalg.norm(errors.velocity, axis=1) > SPEED_GONE
    wrong |= np.linalg.norm(errors.tilt - errors.explained, axis=1) > TILT_GONE
    rows = np.flatnonzero(wrong)
    return 0.0 if len(rows) == 0 else float(rows[-1] + 1) / rate_of(log)


def tilt_quaternions(quaternions: Array, seed: int) -> Array:
    """Turn quaternions (n, 4) w x y z by 30 deg about a horizontal world axis that is drawn."""
    angle = np.random.default_rng([seed, 4]).uniform(0.0, 2.0 * math.pi)
    a, half = math.cos(WRONG_TILT / 2.0), math.sin(WRONG_TILT / 2.0)
    b, c = half * math.cos(angle), half * math.sin(angle)
    w, x, y, z = quaternions.astype(float).T
    rows = [
        a * w - b * x - c * y,
        a * x + b * w + c * z,
        a * y - b * z + c * w,
        a * z + b * y - c * x,
    ]
    return np.stack(rows, axis=1).astype(np.float32)
