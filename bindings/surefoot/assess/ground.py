"""A condition as a plant: settings, and what moves while the robot stands."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

from surefoot.assess.condition import Condition
from surefoot.robots import RobotDescription, build_robot, describe_robot
from surefoot.sim import Flaws, Plant, PlantSettings

PHYSICS_DT = 0.001  # [s]; with half of it limits come out the same (docs/assess.md)

Source = str | tuple[str, str]
"""A robot's name, or the paths of its URDF and TOML: plain, so that it travels."""


def describe(source: Source) -> RobotDescription:
    """Return a robot's files; raises Error."""
    if isinstance(source, str):
        return describe_robot(source)
    return describe_robot(urdf=source[0], config=source[1])


@lru_cache(maxsize=32)
def plant_of(source: Source, condition: Condition) -> Plant:
    """Return a condition's plant, kept from run to run: renew() it, then reset() it."""
    description = describe(source)
    mass = build_robot(description).mass
    return Plant(description, plant_settings(condition, mass))


def plant_settings(condition: Condition, mass: float) -> PlantSettings:
    """Return a condition's settings for a robot of a mass [kg]; seed 0."""
    c = condition
    return PlantSettings(
        physics_dt=PHYSICS_DT,
        friction=c.friction,
        slope_deg=c.slope_deg,
        slope_heading_deg=c.heading_deg,
        payload_kg=c.payload_share * mass,
        payload_position=c.payload_offset_m,
        extra_delay=c.latency_ms / 1000.0,
        joint_friction_scale=c.joint_friction_scale,
        motor_lag=c.motor_lag_ms / 1000.0,
        soft_ground_sink=c.soft_ground_mm / 1000.0,
        flaws=Flaws(),
    )


def mover(condition: Condition, plant: Plant) -> Callable[[float], None] | None:
    """Return what moves the ground, given the time since the quiet ended [s]; None: nothing."""
    return None
