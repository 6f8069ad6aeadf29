"""Scenarios of walking robots; each differs for every robot and seed."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial

import numpy as np
from surefoot.sim import Flaws, PlantSettings
from surefoot.sim.terrain import Terrain
from surefoot.walk import VelocityRequest

from estimation.recording import Scenario

STAND_TIME = 1.5  # [s] time of rest before the first step and after the last one
SIDE = 4.0  # [m] side of the square
TURN_RATE = 1.0  # [rad/s] at the corners of the square
STRAIGHT_TIME = 10.0  # [s] duration of a walk in one direction
MASS_ERROR = 0.05  # largest relative error of the model's trunk mass
FRICTION = (0.5, 1.0)  # range of the friction coefficient


def square(speed: float, robot: str, seed: int) -> Scenario:
    """Return the scenario of one lap of a square, at a speed [m/s]."""
    commands, time = [], STAND_TIME
    for _ in range(4):
        commands.append(VelocityRequest(speed, 0.0, 0.0, time))
        time += SIDE / speed
        commands.append(VelocityRequest(0.0, 0.0, TURN_RATE, time))
        time += 0.5 * math.pi / TURN_RATE
    return _walk(robot, _plant(seed), [*commands, VelocityRequest(0.0, 0.0, 0.0, time)])


def straight(vx: float, vy: float, robot: str, seed: int) -> Scenario:
    """Return the scenario of a walk in one direction [m/s]."""
    return _walk(robot, _plant(seed), _straight(vx, vy))


def rigid_soles(robot: str, seed: int) -> Scenario:
    """Return a walk at 0.5 m/s with the sensors of a stand and rigid soles."""
    plant = _plant(seed, walking_sensors=False, soft_soles=False)
    return _walk(robot, plant, _straight(0.5, 0.0))


def slope(robot: str, seed: int) -> Scenario:
    """Return a walk up or down a slope of 10 deg, or across it."""
    heading = 90.0 * (seed % 4)
    return _walk(
        robot, _plant(seed, slope_deg=10.0, slope_heading_deg=heading), _straight(0.4, 0.0)
    )


def blocks(robot: str, seed: int) -> Scenario:
    """Return a walk over blocks of up to 3 cm."""
    return _walk(
        robot, _plant(seed, terrain=Terrain(block_height=0.03, seed=seed)), _straight(0.4, 0.0)
    )


def ice(robot: str, seed: int) -> Scenario:
    """Return a walk on ground of friction 0.3."""
    return _walk(robot, _plant(seed, friction=0.3), _straight(0.3, 0.0))


WALKING_SCENARIOS: dict[str, Callable[[str, int], Scenario]] = {
    "square05": partial(square, 0.5),
    "square09": partial(square, 0.9),
    "walk05": partial(straight, 0.5, 0.0),
    "walk10": partial(straight, 1.0, 0.0),
    "sideways": partial(straight, 0.0, 0.3),
    "rigid_soles": rigid_soles,
    "slope": slope,
    "blocks": blocks,
    "ice": ice,
}


def _straight(vx: float, vy: float) -> list[VelocityRequest]:
    return [
        VelocityRequest(vx, vy, 0.0, STAND_TIME),
        VelocityRequest(0.0, 0.0, 0.0, STAND_TIME + STRAIGHT_TIME),
    ]


def _walk(robot: str, plant: PlantSettings, velocities: list[VelocityRequest]) -> Scenario:
    duration = velocities[-1].time + STAND_TIME
    return Scenario(robot, duration, plant, velocities=tuple(velocities))


def _plant(seed: int, **settings: object) -> PlantSettings:
    """Return a plant with the errors of walking and a model error that depends on the seed."""
    rng = np.random.default_rng([seed, 5])
    flaws = Flaws(trunk_mass_scale=1.0 + rng.uniform(-MASS_ERROR, MASS_ERROR))
    defaults: dict[str, object] = {
        "walking_sensors": True,
        "soft_soles": True,
        "physics_dt": 0.001,
        "friction": float(rng.uniform(*FRICTION)),
        "flaws": flaws,
        "foot_force": "est" if seed % 2 else "dead",
    }
    return PlantSettings(seed=seed, **{**defaults, **settings})
