"""Metrics of a run; summary_fields.py explains each metric."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from surefoot._core import FallbackLevel, Status, is_usable
from surefoot.files.json_values import json_value
from surefoot.stand.conditions import describe_conditions
from surefoot.stand.foot_frame import angle_between, pose_from_feet, up_in_base, wrap_angle
from surefoot.stand.requested_pose import reference_summary, requested_pose
from surefoot.stand.settling import settle_time, settled_ticks
from surefoot.stand.simulation_log import SimulationLog
from surefoot.stand.spectrum import high_frequency_rms
from surefoot.stand.stand_log import StandLog

# [s] Window at the end of the run for the stillness metrics. Chosen: begins after the robot has
# settled from the last push; long enough for a spectrum at 30 Hz.
STILLNESS_WINDOW = 2.0


def summarise(log: StandLog) -> dict[str, Any]:
    """Return the value of each of summary_fields.FIELDS by name; None: the run has no value."""
    parts = (
        describe_conditions(log),
        _outcome(log),
        _pose_errors(log),
        reference_summary(log),
        _stillness(log),
        describe_effort(log),
        describe_estimator(log),
        _controller_ticks(log),
    )
    return {name: json_value(value) for part in parts for name, value in part.items()}


def _outcome(log: StandLog) -> dict[str, Any]:
    return {
        "fell": log.fell,
        "fall_time_s": log.duration if log.fell else None,
        "settled": not log.fell and bool(settled_ticks(log)[-1]),
        "settle_time_s": settle_time(log),
    }


def _pose_errors(log: StandLog) -> dict[str, Any]:
    pose, requested = pose_from_feet(log.q_true, log.feet), requested_pose(log)
    up = up_in_base(log.q_true)
    tilt = np.degrees(angle_between(up, np.broadcast_to(up[0], up.shape)))
    # The last row of a rotation from base axes to a frame is the frame's z axis in base axes.
    # Here the frame's z axis is world z.
    tilt_error = angle_between(up[-1:], requested.rotation[-1:, 2, :])
    yaw = np.degrees(wrap_angle(pose.rpy[-1, 2] - requested.rpy[-1, 2]))
    displacement = np.linalg.norm(log.feet - log.feet[0], axis=1)
    return {
        "height_error_mm": 1000.0 * abs(pose.position[-1, 2] - requested.position[-1, 2]),
        "tilt_error_deg": np.degrees(tilt_error[0]),
        "yaw_error_deg": abs(yaw),
        "max_tilt_deg": tilt.max(),
        "max_foot_travel_mm": 1000.0 * displacement.max(),
    }


def _stillness(log: StandLog) -> dict[str, Any]:
    last = slice(-max(1, round(STILLNESS_WINDOW * log.rate)), None)
    com = log.com[last] - log.com[last].mean(axis=0)
    return {
        "com_rms_mm": 1000.0 * math.sqrt(np.mean(np.sum(com**2, axis=1))),
        "joint_velocity_rms": math.sqrt(np.mean(log.dq[last] ** 2)),
        "torque_hf_rms": high_frequency_rms(log.tau[last], log.rate).max(),
    }


def describe_effort(log: SimulationLog) -> dict[str, Any]:
    """Return the summary fields of the group Effort."""
    return {
        "peak_torque_ratio": np.max(np.abs(log.tau) / log.robot.config.tau_max),
        "peak_power_w": log.power.max(),
    }


def describe_estimator(log: SimulationLog) -> dict[str, Any]:
    """Return the summary fields of the group Estimator."""
    error = log.v_estimated[:, :3] - log.v_true[:, :3]
    tilt = angle_between(up_in_base(log.q_estimated), up_in_base(log.q_true))
    return {
        "estimator_velocity_rmse": math.sqrt(np.mean(np.sum(error**2, axis=1))),
        "estimator_tilt_rmse_deg": math.degrees(math.sqrt(np.mean(tilt**2))),
    }


def _controller_ticks(log: StandLog) -> dict[str, Any]:
    usable = [status.value for status in Status if is_usable(status)]
    failed = np.flatnonzero(~np.isin(log.status, usable))
    p50, p90, p99 = np.percentile(log.tick_us, [50, 90, 99])
    return {
        "ticks": len(log.time),
        "qp_failures": len(failed),
        "first_failure": Status(int(log.status[failed[0]])).name if len(failed) else None,
        "cold_solves": np.sum(log.fallback_level == FallbackLevel.COLD_SOLVE.value),
        "saturated_ticks": np.sum(log.status == Status.SATURATED.value),
        "torque_mode_only": log.torque_mode.all(),
        "iterations": {"mean": log.iterations.mean(), "max": log.iterations.max()},
        "tick_us": {"p50": p50, "p90": p90, "p99": p99, "max": log.tick_us.max()},
    }
