"""Figures of estimators that start wrong."""

from __future__ import annotations

import math

import numpy as np
from surefoot import Robot

from estimation.errors import Errors, compute_errors
from estimation.figures import Result
from estimation.log_rows import Array, Log
from estimation.recording import sample_rate, select_rows
from estimation.replay import replay
from estimation.rows import push_rows, row_at, true_speed

SPEED_TOLERANCE, TILT_TOLERANCE = 0.05, math.radians(1.0)  # [m/s], [rad] of an error that is gone
INITIAL_TILT_ERROR = math.radians(30.0)


def init(robot: Robot, logs: dict[str, Log], seed: int) -> Result:
    """Time until the error of a wrong start is gone: a tilted quaternion, a base in motion."""
    still, shoved = logs["quiet"], logs["shove"]
    tilted = select_rows(still, slice(0, row_at(still, 5.0)))
    tilted["quaternion"] = tilt_quaternions(tilted["quaternion"], seed)
    times, speeds = [], []
    for begin, end in _moving_segments(shoved):
        log = select_rows(shoved, slice(begin, end))
        times.append(convergence_time(log, compute_errors(log, replay(robot, log))))
        speeds.append(float(true_speed(log)[0]))
    return Result(
        {
            "fell": float(shoved["fell"]),
            "tilted quaternion": convergence_time(
                tilted, compute_errors(tilted, replay(robot, tilted))
            ),
            "moving start": max(times, default=math.nan),
            "speed at start": max(speeds, default=math.nan),
        }
    )


def _moving_segments(log: Log) -> list[tuple[int, int]]:
    """Return (first, end) of pieces of 1.5 s that begin when a push has made the base fastest.

    They end before the next push, whose blow is an error of its own.
    """
    window, length = row_at(log, 0.3), row_at(log, 1.5)
    begins = [
        start + int(np.argmax(true_speed(log)[start : start + window])) for start in push_rows(log)
    ]
    return [(begin, begin + length) for begin in begins]


def convergence_time(log: Log, errors: Errors) -> float:
    """Return the time [s] from which on velocity and tilt, beyond the bias's part, are right."""
    wrong = np.linalg.norm(errors.velocity, axis=1) > SPEED_TOLERANCE
    wrong |= np.linalg.norm(errors.tilt - errors.tilt_from_bias, axis=1) > TILT_TOLERANCE
    rows = np.flatnonzero(wrong)
    return 0.0 if len(rows) == 0 else float(rows[-1] + 1) / sample_rate(log)


def tilt_quaternions(quaternions: Array, seed: int) -> Array:
    """Turn quaternions (n, 4) w x y z by 30 deg about a horizontal world axis that is drawn."""
    angle = np.random.default_rng([seed, 4]).uniform(0.0, 2.0 * math.pi)
    a, half = math.cos(INITIAL_TILT_ERROR / 2.0), math.sin(INITIAL_TILT_ERROR / 2.0)
    b, c = half * math.cos(angle), half * math.sin(angle)
    w, x, y, z = quaternions.astype(float).T
    rows = [
        a * w - b * x - c * y,
        a * x + b * w + c * z,
        a * y - b * z + c * w,
        a * z + b * y - c * x,
    ]
    return np.stack(rows, axis=1).astype(np.float32)
