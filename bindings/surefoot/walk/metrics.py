"""Metrics of a walk; summary_fields.py explains each metric."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from surefoot._core import FallbackLevel, Robot, Status
from surefoot.files.json_values import json_value
from surefoot.stand.conditions import describe_conditions
from surefoot.stand.foot_frame import feet_heading, foot_positions, wrap_angle
from surefoot.stand.metrics import describe_effort, describe_estimator
from surefoot.stand.requested_pose import reach_limit
from surefoot.stand.settling import SETTLED_SPEED
from surefoot.stand.simulation_log import Array
from surefoot.walk.commands import command_figures, worst_command
from surefoot.walk.heading_frame import attitude_on_ground, commanded_path
from surefoot.walk.steps import LOADED, slip_per_step, stance_phases, touchdown_force
from surefoot.walk.walk_log import WalkLog

STANDING_TIME = 0.5  # [s] time at the end in which a robot that stands neither steps nor moves


def summarise(log: WalkLog) -> dict[str, Any]:
    """Return the value of each of summary_fields.FIELDS by name; None: the run has no value."""
    commands = command_figures(log)
    parts = (
        describe_conditions(log),
        _walk_conditions(log),
        _outcome(log),
        worst_command(commands),
        {"commands": commands},
        _feet(log),
        describe_effort(log),
        describe_estimator(log),
        _controller_ticks(log),
    )
    return {name: json_value(value) for part in parts for name, value in part.items()}


def _walk_conditions(log: WalkLog) -> dict[str, Any]:
    plant = log.settings.plant
    return {
        "gait": log.settings.gait.name.lower(),
        "walking_sensors": plant.walking_sensors and plant.real,
        "soft_soles": plant.soft_soles,
        "leg_collisions": plant.leg_collisions,
        "step_height": plant.terrain.step_height,
        "step_heading_deg": plant.terrain.step_heading_deg,
        "stairs_height": plant.terrain.stairs_height,
        "stairs_tread": plant.terrain.stairs_tread,
        "block_height": plant.terrain.block_height,
        "lost_frames": log.settings.lost_frames,
    }


def _outcome(log: WalkLog) -> dict[str, Any]:
    path, yaw = commanded_path(log)[-1], attitude_on_ground(log)[-1, 2]
    return {
        "fell": log.fell,
        "fall_time_s": log.duration if log.fell else None,
        "stands_at_end": stands_at_end(log),
        "reference_limit": reach_limit(log),
        "stance_error_mm": 1000.0 * stance_error(log),
        "path_error_m": np.linalg.norm(log.com[-1, :2] - path[:2]),
        "heading_error_deg": np.degrees(abs(wrap_angle(yaw - path[2]))),
    }


def stands_at_end(log: WalkLog) -> bool:
    """Return whether the robot stands on four feet, without stepping, for the last half second."""
    last = slice(-max(1, round(STANDING_TIME * log.rate)), None)
    return bool(
        not log.fell
        and not log.walking[last].any()
        and (log.normal_forces[last] > LOADED * log.weight).all()
        and (np.linalg.norm(log.v_true[last, :3], axis=1) < SETTLED_SPEED).all()
    )


def stance_error(log: WalkLog) -> float:
    """Return foot_displacement() at the end [m]."""
    return foot_displacement(log.robot, log.feet[-1])


def foot_displacement(robot: Robot, feet: Array) -> float:
    """Return the largest distance of a foot from its place in the standing pose [m].

    The places are relative to the mean and the heading of the feet (3, 4).
    """
    nominal = foot_positions(robot, np.asarray(robot.q_standing())[None])[0]
    offset = _centred_feet(feet) - _centred_feet(nominal)
    return float(np.linalg.norm(offset, axis=0).max())


def _centred_feet(feet: Array) -> Array:
    """Return feet (3, 4) in the horizontal plane (2, 4), relative to their mean and heading [m]."""
    heading = float(feet_heading(feet[None])[0])
    c, s = math.cos(heading), math.sin(heading)
    offset = feet[:2] - feet[:2].mean(axis=1, keepdims=True)
    return np.asarray(np.array([[c, s], [-s, c]]) @ offset)


def _feet(log: WalkLog) -> dict[str, Any]:
    slip = slip_per_step(log)
    return {
        "steps": sum(phase.stepped for phase in stance_phases(log)),
        "slip_mm_per_step": None if slip is None else 1000.0 * slip,
        "touchdown_force_mg": touchdown_force(log),
        "leg_contacts": log.leg_contacts.sum(),
    }


def _controller_ticks(log: WalkLog) -> dict[str, Any]:
    levels = log.fallback_level
    names = {"p50": 50.0, "p90": 90.0, "p99": 99.0, "p99.9": 99.9, "max": 100.0}
    return {
        "ticks": len(log.time),
        "failed_ticks": np.sum(levels != FallbackLevel.SOLVED.value),
        "fallback_levels": {
            FallbackLevel(int(level)).name.lower(): np.sum(levels == level)
            for level in np.unique(levels)
        },
        "saturated_ticks": np.sum(log.status == Status.SATURATED.value),
        "torque_mode_only": log.torque_mode.all(),
        "iterations": {"mean": log.iterations.mean(), "max": log.iterations.max()},
        "tick_us": {name: np.percentile(log.tick_us, share) for name, share in names.items()},
    }
