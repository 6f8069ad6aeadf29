"""Requested base pose at every tick, and the error of the true pose."""

from __future__ import annotations

from typing import Any

import numpy as np

from surefoot._core import ReachLimit
from surefoot.stand.foot_frame import (
    FootFramePose,
    matrices_from_rpy,
    pose_from_feet,
    pose_in_support,
    rotation_angle,
)
from surefoot.stand.reference_request import AXES, first_tick, reference_schedule, to_si
from surefoot.stand.simulation_log import Array, SimulationLog
from surefoot.stand.stand_log import StandLog

# [s] Window at the end of the run in which reach_limit() looks for a limit. Equal to kLimitHoldTime
# in body_motion.cpp, the time for which the controller reports a limit.
LIMIT_WINDOW = 0.1


def requested_offsets(log: StandLog) -> Array:
    """Return the requested offsets (n, 6) from the latched pose at every tick.

    Columns: x, y, height [m], roll, pitch, yaw [rad] in the support frame.
    """
    offsets = np.zeros((len(log.time), len(AXES)))
    for time, requested in reference_schedule(log.settings.references):
        offsets[first_tick(time, log.rate) :] = [to_si(axis, requested[axis]) for axis in AXES]
    return offsets


def requested_pose(log: StandLog) -> FootFramePose:
    """Return the requested pose at every tick, in the frame of pose_from_feet().

    Without references the requested pose is the first true pose. Requested offsets refer to the
    support frame. On a slope the z axis of the support frame is not vertical: it is normal to the
    plane of the feet.
    """
    n = len(log.time)
    first = pose_from_feet(log.q_true[:1], log.feet[:1])
    if not log.settings.references:
        return FootFramePose(
            np.broadcast_to(first.position, (n, 3)), np.broadcast_to(first.rotation, (n, 3, 3))
        )
    support = pose_in_support(log.q_true[:1], log.feet[:1])
    from_support = first.rotation[0] @ support.rotation[0].T
    offsets = requested_offsets(log)
    turn = from_support @ matrices_from_rpy(offsets[:, 3:]) @ from_support.T
    return FootFramePose(first.position + offsets[:, :3] @ from_support.T, turn @ first.rotation[0])


def reference_summary(log: StandLog) -> dict[str, Any]:
    """Return the summary fields of the group References; None: the run has no references."""
    fields: dict[str, Any] = {
        "reference_error_mm": None,
        "reference_error_deg": None,
        "reference_reached": None,
        "reference_limit": reach_limit(log),
    }
    if not log.settings.references:
        return fields
    ends = [0, -1]
    pose = pose_in_support(log.q_true[ends], log.feet[ends])
    displacement = pose.position[1] - pose.position[0]
    turn = FootFramePose(pose.position[1:], pose.rotation[1:] @ pose.rotation[0].T)
    requested = requested_offsets(log)[-1]
    rotation_error = matrices_from_rpy(requested[None, 3:])[0].T @ turn.rotation
    reached = [*(1000.0 * displacement), *np.degrees(turn.rpy[0])]
    fields["reference_error_mm"] = 1000.0 * np.linalg.norm(displacement - requested[:3])
    fields["reference_error_deg"] = np.degrees(rotation_angle(rotation_error)[0])
    fields["reference_reached"] = {
        f"{axis}_{'mm' if unit == 'm' else unit}": value
        for (axis, unit), value in zip(AXES.items(), reached, strict=True)
    }
    return fields


def reach_limit(log: SimulationLog) -> str:
    """Return the limit that stopped the body reference: none, joint NAME, support, foot height ...

    The controller clears a limit when no axis has been blocked for 0.1 s. Then the body reference
    may reach the same limit again. So this function returns the last limit that was reported within
    the last LIMIT_WINDOW seconds.
    """
    last = slice(-max(1, round(LIMIT_WINDOW * log.rate)), None)
    limited_ticks = np.flatnonzero(log.reach[last] != ReachLimit.NONE.value)
    if len(limited_ticks) == 0:
        return "none"
    limit = ReachLimit(int(log.reach[last][limited_ticks[-1]]))
    if limit == ReachLimit.JOINT:
        return f"joint {log.robot.config.joint_names[log.reach_motor[last][limited_ticks[-1]]]}"
    return limit.name.lower().replace("_", " ")
