"""When a robot stands again as it stood before."""

from __future__ import annotations

import math

import numpy as np

from surefoot.stand.geometry import pose_from_feet, rotation_angle
from surefoot.stand.log import StandLog

SETTLED_DISTANCE = 0.010  # [m]
SETTLED_ANGLE = math.radians(2.0)
SETTLED_SPEED = 0.05  # [m/s]


def settled_ticks(log: StandLog) -> np.ndarray:
    """Return (n,) whether the robot stands where, as and as still as it began.

    Place and attitude are relative to the true feet: a robot whose feet were shoved stands well
    if it stands over them.
    """
    pose = pose_from_feet(log.q_true, log.feet)
    moved = np.linalg.norm(pose.position - pose.position[0], axis=1)
    turned = rotation_angle(pose.rotation[0].T @ pose.rotation)
    speed = np.linalg.norm(log.v_true[:, :3], axis=1)
    return np.asarray(
        (moved <= SETTLED_DISTANCE) & (turned <= SETTLED_ANGLE) & (speed < SETTLED_SPEED)
    )


def settle_time(log: StandLog) -> float | None:
    """Return the time from the end of the last push until the robot is settled for good [s]."""
    if not log.pushes or log.fell:
        return None
    settled = settled_ticks(log)
    end = max(push.time + push.duration for push in log.pushes)
    if log.time[-1] < end or not settled[-1]:
        return None
    unsettled = np.flatnonzero(~settled)
    first = 0 if len(unsettled) == 0 else unsettled[-1] + 1
    return max(0.0, float(log.time[first]) - end)
