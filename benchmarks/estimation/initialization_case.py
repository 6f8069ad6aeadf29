"""Case init: figures of estimators with a wrong initial state."""

from __future__ import annotations

import math

import numpy as np
from surefoot import Robot

from estimation.errors import Errors, compute_errors
from estimation.log_rows import Array, Log
from estimation.metrics import Result
from estimation.recording import sample_rate, select_rows
from estimation.replay import replay
from estimation.row_selection import push_rows, row_at, true_speed

# [m/s], [rad] Errors below which the estimate has converged.
SPEED_TOLERANCE, TILT_TOLERANCE = 0.05, math.radians(1.0)
INITIAL_TILT_ERROR = math.radians(30.0)  # [rad] tilt error of the quaternion at the start


def init(robot: Robot, logs: dict[str, Log], seed: int) -> Result:
    """Evaluate the convergence time after a start with a tilted quaternion, and in motion."""
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
    """Return (first, end) of segments of 1.5 s that start at the largest speed after a push.

    Each segment ends before the next push, because the push would cause further errors.
    """
    window, length = row_at(log, 0.3), row_at(log, 1.5)
    begins = [
        start + int(np.argmax(true_speed(log)[start : start + window])) for start in push_rows(log)
    ]
    return [(begin, begin + length) for begin in begins]


def convergence_time(log: Log, errors: Errors) -> float:
    """Return the time [s] after which the errors of velocity and tilt stay below the tolerances.

    The part of the tilt error that is due to the accelerometer bias does not count.
    """
    wrong = np.linalg.norm(errors.velocity, axis=1) > SPEED_TOLERANCE
    wrong |= np.linalg.norm(errors.tilt - errors.tilt_from_bias, axis=1) > TILT_TOLERANCE
    rows = np.flatnonzero(wrong)
    return 0.0 if len(rows) == 0 else float(rows[-1] + 1) / sample_rate(log)


def tilt_quaternions(quaternions: Array, seed: int) -> Array:
    """Return quaternions (n, 4) w x y z, rotated by 30 deg about a random horizontal world axis."""
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
