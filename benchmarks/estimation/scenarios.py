"""Scenarios to record, by name; each differs for every robot and seed."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from surefoot.sim import Flaws, Lift, PlantSettings
from surefoot.sim.physics.external_lift import LIFT_PARTS
from surefoot.stand import PushRequest, ReferenceRequest

from estimation.recording import Scenario
from estimation.stepping import Step

# [rad/s], [m/s^2] Standard deviations of random biases.
GYRO_BIAS_SIGMA, ACCELEROMETER_BIAS_SIGMA = 0.01, 0.1
LARGE_GYRO_BIAS, LARGE_ACCELEROMETER_BIAS = 0.02, 0.2  # [rad/s], [m/s^2] in the scenario bias
PUSH_PERCENT, SHOVE_PERCENT = 60.0, 70.0  # [% of the LIP push limit] impulses of the pushes
PUSH_TIMES = (1.5, 3.5, 5.5, 7.5)  # [s] start of each push
STILL_TIME = 10.0  # [s] time of rest before the body moves in the scenario bias
SWAY_DEG = 10.0  # [deg] amplitude of the motions in the scenario bias
FAST_LIFT_SPEED = 1.2  # [m/s] lift that unloads each foot by 20 % of the weight within 20 ms

REFERENCE_INTERVAL = 1.0  # [s] time between two body references


def quiet(robot: str, seed: int) -> Scenario:
    """Return the scenario of standing for a minute."""
    return Scenario(robot, 60.0, PlantSettings(seed=seed))


def quiet_long(robot: str, seed: int) -> Scenario:
    """Return the scenario of standing for ten minutes."""
    return Scenario(robot, 600.0, PlantSettings(seed=seed))


def push60(robot: str, seed: int) -> Scenario:
    """Return a scenario with pushes of 60 % of the LIP push limit, and with random biases."""
    return _pushed(robot, seed, PUSH_PERCENT, 10.0)


def shove(robot: str, seed: int) -> Scenario:
    """Return a scenario with pushes of 70 % of the LIP push limit, for replays from motion on."""
    return _pushed(robot, seed, SHOVE_PERCENT, 10.0)


def lifts(robot: str, seed: int) -> Scenario:
    """Return a scenario with external lifts of the trunk: five fast lifts, then a slow lift."""
    rng = np.random.default_rng([seed, 1])
    lifts = [
        Lift(
            "trunk", 1.5 + 2.5 * k, rng.uniform(0.4, 0.7), rng.uniform(0.05, 0.07), FAST_LIFT_SPEED
        )
        for k in range(5)
    ]
    lifts.append(Lift("trunk", 14.0, 2.0, 0.06, 0.04, 0.8))
    return Scenario(robot, 20.0, _plant_with_foot_forces(seed), lifts=tuple(lifts))


def feet(robot: str, seed: int) -> Scenario:
    """Return a scenario with external lifts of each foot: three fast lifts, then a slow lift."""
    rng = np.random.default_rng([seed, 2])
    lifts, time = [], 1.5
    for part in LIFT_PARTS[1:]:
        for _ in range(3):
            lifts.append(Lift(part, time, rng.uniform(0.3, 0.6), rng.uniform(0.025, 0.035)))
            time += 1.6
        lifts.append(Lift(part, time, 1.0, 0.03, 0.1, 0.5))
        time += 2.6
    return Scenario(robot, time + 1.0, _plant_with_foot_forces(seed), lifts=tuple(lifts))


def steps(robot: str, seed: int) -> Scenario:
    """Return a scenario with fast steps: the robot lifts each foot three times."""
    rng = np.random.default_rng([seed, 4])
    steps, time = [], 1.5
    for foot in np.tile(np.arange(4), 3):
        steps.append(Step(int(foot), time, rng.uniform(0.2, 0.3), rng.uniform(0.03, 0.05)))
        time += 1.6
    return Scenario(robot, time, _plant_with_foot_forces(seed), steps=tuple(steps))


def bias(robot: str, seed: int) -> Scenario:
    """Return a scenario with large biases: ten seconds at rest, then roll, pitch, yaw motions."""
    signs = np.random.default_rng([seed, 3]).choice([-1.0, 1.0], 6)
    gyro, accelerometer = LARGE_GYRO_BIAS * signs[:3], LARGE_ACCELEROMETER_BIAS * signs[3:]
    flaws = Flaws(_as_tuple(gyro), _as_tuple(accelerometer))
    references, time = [], STILL_TIME
    for axis in ("roll", "pitch", "yaw"):
        for degrees in (SWAY_DEG, -SWAY_DEG, SWAY_DEG, -SWAY_DEG, 0.0):
            references.append(ReferenceRequest({axis: degrees}, time))
            time += REFERENCE_INTERVAL
    plant = PlantSettings(seed=seed, flaws=flaws)
    return Scenario(robot, time + 3.0, plant, references=tuple(references))


SCENARIOS: dict[str, Callable[[str, int], Scenario]] = {
    "quiet": quiet,
    "quiet_long": quiet_long,
    "push60": push60,
    "shove": shove,
    "lifts": lifts,
    "feet": feet,
    "steps": steps,
    "bias": bias,
}


def _pushed(robot: str, seed: int, percent: float, duration: float) -> Scenario:
    rng = np.random.default_rng([seed, 0])
    pushes = tuple(
        PushRequest(float(rng.uniform(-180.0, 180.0)), percent, True, 0.1, time)
        for time in PUSH_TIMES
    )
    flaws = Flaws(GYRO_BIAS_SIGMA, ACCELEROMETER_BIAS_SIGMA)
    return Scenario(robot, duration, PlantSettings(seed=seed, flaws=flaws), pushes)


def _plant_with_foot_forces(seed: int) -> PlantSettings:
    # The controller needs working foot force sensors to survive the lifts. The replay may use other
    # sensor conditions.
    return PlantSettings(seed=seed, foot_force="est")


def _as_tuple(values: np.ndarray) -> tuple[float, float, float]:
    x, y, z = (float(value) for value in values)
    return x, y, z
