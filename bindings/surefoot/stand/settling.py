"""When a robot stands again as it stood before."""

from __future__ import annotations

import math

import numpy as np

from surefoot.stand.foot_frame import pose_from_feet, rotation_angle
from surefoot.stand.requested_pose import requested_pose
from surefoot.stand.stand_log import StandLog

SETTLED_DISTANCE = 0.010  # [m]
SETTLED_ANGLE = math.radians(2.0)
SETTLED_SPEED = 0.05  # [m/s]


def settled_ticks(log: StandLog) -> np.ndarray:
    """Return (n,) whether the robot stands where, as and as still as it began or was asked to.

    Place and attitude are relative to the true feet: a robot whose feet were shoved stands well
    if it stands over them.
    """
    pose = pose_from_feet(log.q_true, log.feet)
    requested = requested_pose(log)
    distance = np.linalg.norm(pose.position - requested.position, axis=1)
    angle = rotation_angle(np.swapaxes(requested.rotation, 1, 2) @ pose.rotation)
    speed = np.linalg.norm(log.v_true[:, :3], axis=1)
    return np.asarray(
        (distance <= SETTLED_DISTANCE) & (angle <= SETTLED_ANGLE) & (speed < SETTLED_SPEED)
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
