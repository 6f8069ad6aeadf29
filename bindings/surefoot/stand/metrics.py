"""A run in numbers; fields.py says what each one means."""

from __future__ import annotations

import importlib.metadata
import math
from typing import Any

import numpy as np

from surefoot._core import Status, gain_table, get_gain
from surefoot.stand.geometry import (
    FootFramePose,
    angle_between,
    pose_from_feet,
    up_in_base,
    wrap,
)
from surefoot.stand.log import StandLog
from surefoot.stand.settling import settle_time, settled_ticks
from surefoot.stand.spectrum import high_frequency_rms

WINDOW = 2.0  # [s] at the end of the run over which stillness is measured


def summarise(log: StandLog) -> dict[str, Any]:
    """Return every field of fields.FIELDS as plain JSON types; what has no value is None."""
    parts = (
        _conditions(log),
        _outcome(log),
        _pose_errors(log),
        _stillness(log),
        _effort(log),
        _estimator(log),
        _loop(log),
    )
    return {name: plain(value) for part in parts for name, value in part.items()}


def plain(value: Any) -> Any:
    """Return a value as JSON knows it: six digits, None for what is not finite."""
    if isinstance(value, dict):
        return {str(name): plain(item) for name, item in value.items()}
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    if isinstance(value, bool | np.bool_):
        return bool(value)
    if isinstance(value, int | np.integer):
        return int(value)
    if isinstance(value, float | np.floating):
        return float(f"{value:.6g}") if math.isfinite(value) else None
    return value


def _conditions(log: StandLog) -> dict[str, Any]:
    settings, plant = log.settings, log.settings.plant
    return {
        "version": importlib.metadata.version("surefoot"),
        "robot": log.robot.name,
        "seed": plant.seed,
        "sensors": plant.sensors,
        "foot_force": log.foot_force,
        "rate": log.rate,
        "duration": log.duration,
        "friction": plant.friction,
        "soft_ground_sink": plant.soft_ground_sink,
        "slope_deg": plant.slope_deg,
        "slope_heading_deg": plant.slope_heading_deg,
        "payload_kg": plant.payload_kg,
        "payload_position": list(plant.payload_position),
        "joint_friction_scale": plant.joint_friction_scale,
        "armature_scale": plant.armature_scale,
        "backlash_deg": plant.backlash_deg,
        "motor_lag_ms": 1000.0 * plant.lag,
        "delay_ms": 1000.0 * plant.extra_delay,
        "motor_damping": settings.motor_damping,
        "gains_changed": _gains_changed(log),
        "lip_limit_ns": log.lip_limit,
        "pushes": [
            {
                "direction": push.direction,
                "impulse_ns": push.impulse,
                "lip_share": share,
                "duration_s": push.duration,
                "time_s": push.time,
                "height_m": push.height,
            }
            for push, share in zip(log.pushes, log.push_shares, strict=True)
        ],
    }


def _gains_changed(log: StandLog) -> dict[str, float]:
    gains, own = log.settings.gains, log.robot.config.gains
    if gains is None:
        return {}
    names = [row.name for row in gain_table()]
    values = {name: get_gain(gains, name) for name in names}
    return {name: value for name, value in values.items() if value != get_gain(own, name)}


def _outcome(log: StandLog) -> dict[str, Any]:
    return {
        "fell": log.fell,
        "fall_time_s": log.duration if log.fell else None,
        "settled": not log.fell and bool(settled_ticks(log)[-1]),
        "settle_time_s": settle_time(log),
    }


def _pose_errors(log: StandLog) -> dict[str, Any]:
    pose: FootFramePose = pose_from_feet(log.q_true, log.feet)
    up = up_in_base(log.q_true)
    tilt = np.degrees(angle_between(up, np.broadcast_to(up[0], up.shape)))
    yaw = np.degrees(wrap(pose.rpy[:, 2] - pose.rpy[0, 2]))
    travel = np.linalg.norm(log.feet - log.feet[0], axis=1)
    return {
        "height_error_mm": 1000.0 * abs(pose.position[-1, 2] - pose.position[0, 2]),
        "tilt_error_deg": tilt[-1],
        "yaw_error_deg": abs(yaw[-1]),
        "max_tilt_deg": tilt.max(),
        "max_foot_travel_mm": 1000.0 * travel.max(),
    }


def _stillness(log: StandLog) -> dict[str, Any]:
    last = slice(-max(1, round(WINDOW * log.rate)), None)
    com = log.com[last] - log.com[last].mean(axis=0)
    return {
        "com_rms_mm": 1000.0 * math.sqrt(np.mean(np.sum(com**2, axis=1))),
        "joint_velocity_rms": math.sqrt(np.mean(log.dq[last] ** 2)),
        "torque_hf_rms": high_frequency_rms(log.tau[last], log.rate).max(),
    }


def _effort(log: StandLog) -> dict[str, Any]:
    return {
        "peak_torque_ratio": np.max(np.abs(log.tau) / log.robot.config.tau_max),
        "peak_power_w": log.power.max(),
    }


def _estimator(log: StandLog) -> dict[str, Any]:
    error = log.v_estimated[:, :3] - log.v_true[:, :3]
    tilt = angle_between(up_in_base(log.q_estimated), up_in_base(log.q_true))
    return {
        "estimator_velocity_rmse": math.sqrt(np.mean(np.sum(error**2, axis=1))),
        "estimator_tilt_rmse_deg": math.degrees(math.sqrt(np.mean(tilt**2))),
    }


def _loop(log: StandLog) -> dict[str, Any]:
    bad = np.flatnonzero(log.status != Status.OK.value)
    p50, p90, p99 = np.percentile(log.tick_us, [50, 90, 99])
    return {
        "ticks": len(log.time),
        "qp_failures": len(bad),
        "first_failure": Status(int(log.status[bad[0]])).name if len(bad) else None,
        "torque_mode_only": log.torque_mode.all(),
        "iterations": {"mean": log.iterations.mean(), "max": log.iterations.max()},
        "tick_us": {"p50": p50, "p90": p90, "p99": p99, "max": log.tick_us.max()},
    }
