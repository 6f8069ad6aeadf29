"""Plant settings and ground motion of a condition."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache

from surefoot.assess.condition import Condition
from surefoot.assess.robot_source import MjcfSource, RobotSource, describe_source
from surefoot.robot.loading import build_robot
from surefoot.sim import Flaws, Plant, PlantSettings
from surefoot.sim.model.moving_ground import set_ground_speed
from surefoot.sim.model.mujoco_model import trunk_mass
from surefoot.sim.settings import COARSE_DT

# [s] Time in which the ground under a foot rises by step_m. Chosen as part of the protocol in
# docs/reference/scorecard.md: a step of 3 cm then rises at 6 cm/s. A faster step would throw the
# foot up.
STEP_RISE_TIME = 0.5


@lru_cache(maxsize=32)
def plant_of(source: RobotSource, condition: Condition) -> Plant:
    """Return the cached plant of a condition; call reseed() and reset() before each run."""
    return Plant(describe_source(source), source_settings(source, condition))


def source_settings(source: RobotSource, condition: Condition) -> PlantSettings:
    """Return the plant settings of a condition for a robot, with seed 0.

    The friction of a plant from an MJCF is that of the file, whatever the condition says.
    """
    description = describe_source(source)
    robot = build_robot(description)
    settings = plant_settings(condition, robot.mass, trunk_mass(robot, description))
    if isinstance(source, MjcfSource):
        settings = replace(settings, friction=PlantSettings.friction)
    return settings


def plant_settings(condition: Condition, mass: float, trunk: float) -> PlantSettings:
    """Return the plant settings of a condition, with seed 0.

    Args:
        condition: The condition; only its first heading is used.
        mass: Mass of the robot [kg].
        trunk: Mass of the robot's trunk alone [kg].
    """
    c = condition
    return PlantSettings(
        physics_dt=COARSE_DT,
        friction=c.friction,
        slope_deg=c.slope_deg,
        slope_heading_deg=c.headings_deg[0],
        payload_kg=c.payload_share * mass,
        payload_position=c.payload_offset_m,
        extra_delay=c.latency_ms / 1000.0,
        joint_friction_scale=c.joint_friction_scale,
        motor_lag=c.motor_lag_ms / 1000.0,
        soft_ground_sink=c.soft_ground_mm / 1000.0,
        platform_heading_deg=c.headings_deg[0] if c.tilt_deg > 0.0 else None,
        block_foot=c.step_foot or None,
        flaws=Flaws(
            torque_scale=c.torque_scale, trunk_mass_scale=1.0 + c.mass_share * mass / trunk
        ),
    )


def loop_delay(plant: Plant) -> float:
    """Return the delay from a measurement until the resulting command acts [s]."""
    settings = plant.settings
    # Real sensors delay samples and commands by one control period each. Plant.step() rounds the
    # extra delay to whole physics steps.
    extra = round(settings.extra_delay / settings.physics_dt) * settings.physics_dt
    return (2.0 if settings.real else 0.0) / settings.control_rate + extra


def ground_motion_time(condition: Condition) -> float:
    """Return the time during which the ground moves [s]; 0 if it does not move."""
    tilt_time = condition.tilt_deg / condition.tilt_deg_per_s
    return max(tilt_time, STEP_RISE_TIME if condition.step_foot else 0.0)


def ground_mover(condition: Condition, plant: Plant) -> Callable[[float], None] | None:
    """Return the function that moves the ground, or None if the ground does not move.

    The function must be called in every tick with the time since the end of the quiet phase [s].
    """
    if not condition.ground_moves:
        return None
    displacement = (
        math.radians(condition.tilt_deg) if condition.tilt_deg > 0.0 else condition.step_m
    )
    time = ground_motion_time(condition)

    def move(time_since_quiet: float) -> None:
        set_ground_speed(
            plant.model, plant.data, displacement / time if 0.0 <= time_since_quiet < time else 0.0
        )

    return move
