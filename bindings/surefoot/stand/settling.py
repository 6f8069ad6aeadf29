"""Settling: when a robot stands again in its desired pose."""

from __future__ import annotations

import math

import numpy as np

from surefoot.stand.foot_frame import pose_from_feet, rotation_angle
from surefoot.stand.requested_pose import requested_pose
from surefoot.stand.stand_log import StandLog

# Chosen: larger than the sway at rest; an engineer beside the robot begins to notice such errors
# (tune/cost.py).
SETTLED_DISTANCE = 0.010  # [m] tolerance of the base position
SETTLED_ANGLE = math.radians(2.0)  # [rad] tolerance of the base attitude
SETTLED_SPEED = 0.05  # [m/s] tolerance of the base speed


def settled_ticks(log: StandLog) -> np.ndarray:
    """Return a mask (n,) of ticks at which the robot stands still in its desired pose.

    The desired pose is the requested pose or, without references, the first pose. Both poses are
    relative to the true feet. So a robot that stepped is settled if its base is above its feet.
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
    """Return the time from the last event until the robot stays settled [s], or None.

    The last event is the end of the last push or the last reference, whichever is later. None: the
    run has no event, the robot fell, or the robot is not settled at the end of the run.
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
