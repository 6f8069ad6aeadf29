"""When a robot stands again as it stood before."""

from __future__ import annotations

import math

import numpy as np

from surefoot.stand.asked import asked_pose
from surefoot.stand.geometry import pose_from_feet, rotation_angle
from surefoot.stand.log import StandLog

SETTLED_DISTANCE = 0.010  # [m]
SETTLED_ANGLE = math.radians(2.0)
SETTLED_SPEED = 0.05  # [m/s]


def settled_ticks(log: StandLog) -> np.ndarray:
    """Return (n,) whether the robot stands where, as and as still as it began or was asked to.

    Place and attitude are relative to the true feet: a robot whose feet were shoved stands well
    if it stands over them.
    """
    pose = pose_from_feet(log.q_true, log.feet)
    asked = asked_pose(log)
    moved = np.linalg.norm(pose.position - asked.position, axis=1)
    turned = rotation_angle(np.swapaxes(asked.rotation, 1, 2) @ pose.rotation)
    speed = np.linalg.norm(log.v_true[:, :3], axis=1)
    return np.asarray(
        (moved <= SETTLED_DISTANCE) & (turned <= SETTLED_ANGLE) & (speed < SETTLED_SPEED)
    )


def settle_time(log: StandLog) -> float | None:
    """Return the time from the last event until the robot is settled for good [s].

    The last event is the end of the last push or the last reference, whichever is later.
    """
    ends = [push.time + push.duration for push in log.pushes]
    ends += [request.time for request in log.settings.references]
    if not ends or log.fell:
        return None
    settled = settled_ticks(log)
    end = max(ends)
    if log.time[-1] < end or not settled[-1]:
        return None
    unsettled = np.flatnonzero(~settled)
    first = 0 if len(unsettled) == 0 else unsettled[-1] + 1
    return max(0.0, float(log.time[first]) - end)
