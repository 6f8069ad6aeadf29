"""Figures of reports that are lost, frozen or doubled, in pushes."""

from __future__ import annotations

import numpy as np
from surefoot import Robot

from estimation.errors import Errors, compare, rms
from estimation.figures import Result
from estimation.log_rows import Log
from estimation.recording import cut
from estimation.replay import replay
from estimation.rows import SETTLED, after, pushes, rows_of

FREEZE = 0.050  # [s]
PUSH_MIDDLE = 0.05  # [s] after a push's begin
LOST_ROWS = 3


def dropout(robot: Robot, logs: dict[str, Log], seed: int) -> Result:
    """Errors while the IMU freezes, its samples come twice, or reports are lost, in pushes."""
    log = logs["push60"]
    frozen, jumped = compare_of(robot, freeze(log)), compare_of(robot, lose(log))
    doubled = compare_of(robot, double(log))
    rows = after(log, SETTLED)
    last = slice(-rows_of(log, 1.0), None)
    ends = max(rms(np.linalg.norm(e.velocity[last], axis=1)) for e in (frozen, jumped, doubled))
    return Result(
        {
            "fell": float(log["fell"]),
            "frozen IMU, velocity error": _most(frozen, rows),
            "doubled accelerometer, velocity RMSE": rms(
                np.linalg.norm(doubled.velocity[rows], axis=1)
            ),
            "lost rows, velocity error": _most(jumped, rows),
            "velocity RMSE at the end": ends,
        }
    )


def compare_of(robot: Robot, log: Log) -> Errors:
    """Return the errors of a replay."""
    return compare(log, replay(robot, log))


def _most(errors: Errors, rows: slice) -> float:
    return float(np.linalg.norm(errors.velocity[rows], axis=1).max())


def freeze(log: Log) -> Log:
    """Let the whole IMU repeat itself for 50 ms in the middle of every push."""
    out, length = dict(log), rows_of(log, FREEZE)
    for name in ("gyroscope", "accelerometer", "quaternion"):
        out[name] = log[name].copy()
        for row in pushes(log):
            start = row + rows_of(log, PUSH_MIDDLE)
            out[name][start : start + length] = log[name][start - 1]
    return out


def double(log: Log) -> Log:
    """Let every second sample of the accelerometer be the one before it."""
    accelerometer = log["accelerometer"].copy()
    pairs = len(accelerometer) // 2
    accelerometer[1 : 2 * pairs : 2] = accelerometer[0 : 2 * pairs : 2]
    return {**log, "accelerometer": accelerometer}


def lose(log: Log) -> Log:
    """Lose three reports in the middle of every push and every half second."""
    n = len(log["tick"])
    starts = [row + rows_of(log, PUSH_MIDDLE) for row in pushes(log)]
    starts += range(rows_of(log, 0.5), n - LOST_ROWS, rows_of(log, 0.5))
    keep = np.ones(n, bool)
    for start in starts:
        keep[start : start + LOST_ROWS] = False
    return cut(log, keep)
