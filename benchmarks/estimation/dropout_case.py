"""Case dropout: figures of lost, frozen or repeated LowStates during pushes."""

from __future__ import annotations

import numpy as np
from surefoot import Robot

from estimation.errors import Errors, compute_errors, rms
from estimation.log_rows import Log
from estimation.metrics import Result
from estimation.recording import select_rows
from estimation.replay import replay
from estimation.row_selection import SETTLING_TIME, push_rows, row_at, rows_after

FREEZE_TIME = 0.050  # [s] duration for which the IMU is frozen
FAULT_AFTER_PUSH = 0.05  # [s] time from the start of a push to the fault
LOST_ROW_COUNT = 3  # number of consecutive LowStates that are lost


def dropout(robot: Robot, logs: dict[str, Log], seed: int) -> Result:
    """Evaluate errors in pushes with a frozen IMU, repeated samples, or lost LowStates."""
    log = logs["push60"]
    frozen, dropped = replay_errors(robot, freeze_imu(log)), replay_errors(robot, drop_rows(log))
    doubled = replay_errors(robot, repeat_samples(log))
    rows = rows_after(log, SETTLING_TIME)
    last = slice(-row_at(log, 1.0), None)
    ends = max(rms(np.linalg.norm(e.velocity[last], axis=1)) for e in (frozen, dropped, doubled))
    return Result(
        {
            "fell": float(log["fell"]),
            "frozen IMU, velocity error": _max_velocity_error(frozen, rows),
            "doubled accelerometer, velocity RMSE": rms(
                np.linalg.norm(doubled.velocity[rows], axis=1)
            ),
            "lost rows, velocity error": _max_velocity_error(dropped, rows),
            "velocity RMSE at the end": ends,
        }
    )


def replay_errors(robot: Robot, log: Log) -> Errors:
    """Replay a log and return the errors."""
    return compute_errors(log, replay(robot, log))


def _max_velocity_error(errors: Errors, rows: slice) -> float:
    return float(np.linalg.norm(errors.velocity[rows], axis=1).max())


def freeze_imu(log: Log) -> Log:
    """Return a log in which all IMU values are frozen for 50 ms during every push."""
    out, length = dict(log), row_at(log, FREEZE_TIME)
    for name in ("gyroscope", "accelerometer", "quaternion"):
        out[name] = log[name].copy()
        for row in push_rows(log):
            start = row + row_at(log, FAULT_AFTER_PUSH)
            out[name][start : start + length] = log[name][start - 1]
    return out


def repeat_samples(log: Log) -> Log:
    """Return a log in which every second accelerometer sample repeats the sample before it."""
    accelerometer = log["accelerometer"].copy()
    pairs = len(accelerometer) // 2
    accelerometer[1 : 2 * pairs : 2] = accelerometer[0 : 2 * pairs : 2]
    return {**log, "accelerometer": accelerometer}


def drop_rows(log: Log) -> Log:
    """Return a log without three LowStates in every push, and without three every half second."""
    n = len(log["tick"])
    starts = [row + row_at(log, FAULT_AFTER_PUSH) for row in push_rows(log)]
    starts += range(row_at(log, 0.5), n - LOST_ROW_COUNT, row_at(log, 0.5))
    keep = np.ones(n, bool)
    for start in starts:
        keep[start : start + LOST_ROW_COUNT] = False
    return select_rows(log, keep)
