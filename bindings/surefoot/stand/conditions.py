"""Conditions of a run, as the summary reports them."""

from __future__ import annotations

import importlib.metadata
from typing import Any

from surefoot.robot.gain_files import changed_gains
from surefoot.stand.reference_request import AXES
from surefoot.stand.simulation_log import SimulationLog


def describe_conditions(log: SimulationLog) -> dict[str, Any]:
    """Return the summary fields of the group Conditions: plant, options, pushes, references."""
    settings, plant = log.settings, log.settings.plant
    return {
        "version": importlib.metadata.version("surefoot"),
        "robot": log.robot.name,
        "seed": plant.seed,
        "sensors": plant.sensors,
        "foot_force": log.foot_force,
        "rate": log.rate,
        "duration": log.duration,
        "mjcf": _mjcf(log),
        "friction": log.ground_friction,
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
        "form": settings.form.name.lower(),
        "predict_ms": 1000.0 * settings.predicted_delay,
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
        "references": [
            {
                "time_s": request.time,
                **{f"{axis}_{AXES[axis]}": value for axis, value in request.offsets.items()},
            }
            for request in settings.references
        ],
    }


def _mjcf(log: SimulationLog) -> str | None:
    robot = log.settings.robot
    return None if isinstance(robot, str) or robot.mjcf is None else str(robot.mjcf)


def _gains_changed(log: SimulationLog) -> dict[str, float]:
    gains, default_gains = log.settings.gains, log.robot.config.gains
    return {} if gains is None else changed_gains(gains, default_gains)
