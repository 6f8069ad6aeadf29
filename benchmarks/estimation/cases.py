"""What is recorded: the runs by name, each different for every robot and seed."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from surefoot.sim import Flaws, Lift, PlantSettings
from surefoot.sim.hands import PARTS
from surefoot.stand import PushRequest, ReferenceRequest

from estimation.recording import Recording
from estimation.stepping import Step

GYRO_SIGMA, ACCELEROMETER_SIGMA = 0.01, 0.1  # [rad/s], [m/s^2] of biases drawn normally
GYRO_BIAS, ACCELEROMETER_BIAS = 0.02, 0.2  # [rad/s], [m/s^2] that are to be found
PUSH_SHARE, SHOVE_SHARE = 60.0, 70.0  # percent of the pendulum's limit
PUSH_TIMES = (1.5, 3.5, 5.5, 7.5)  # [s]
STILL = 10.0  # [s] before the body moves, in the case of biases
SWAY_DEG = 10.0
SNATCH = 1.2  # [m/s] of a lift that takes a fifth of the weight off each foot within 20 ms

_STEP = 1.0  # [s] between references


def quiet(robot: str, seed: int) -> Recording:
    """Stand for a minute."""
    return Recording(robot, 60.0, PlantSettings(seed=seed))


def quiet_long(robot: str, seed: int) -> Recording:
    """Stand for ten minutes."""
    return Recording(robot, 600.0, PlantSettings(seed=seed))


def push60(robot: str, seed: int) -> Recording:
    """Four pushes at 60 % of the limit in directions drawn; biases drawn normally."""
    return _pushed(robot, seed, PUSH_SHARE, 10.0)


def shove(robot: str, seed: int) -> Recording:
    """Four pushes at 70 % of the limit, for logs that are to begin in full motion."""
    return _pushed(robot, seed, SHOVE_SHARE, 10.0)


def lifts(robot: str, seed: int) -> Recording:
    """The trunk lifted off and put down five times in an instant, then once slowly."""
    rng = np.random.default_rng([seed, 1])
    lifts = [
        Lift("trunk", 1.5 + 2.5 * k, rng.uniform(0.4, 0.7), rng.uniform(0.05, 0.07), SNATCH)
        for k in range(5)
    ]
    lifts.append(Lift("trunk", 14.0, 2.0, 0.06, 0.04, 0.8))
    return Recording(robot, 20.0, _contact_plant(seed), lifts=tuple(lifts))


def feet(robot: str, seed: int) -> Recording:
    """Each foot lifted and put down three times in an instant, then once slowly."""
    rng = np.random.default_rng([seed, 2])
    lifts, time = [], 1.5
    for part in PARTS[1:]:
        for _ in range(3):
            lifts.append(Lift(part, time, rng.uniform(0.3, 0.6), rng.uniform(0.025, 0.035)))
            time += 1.6
        lifts.append(Lift(part, time, 1.0, 0.03, 0.1, 0.5))
        time += 2.6
    return Recording(robot, time + 1.0, _contact_plant(seed), lifts=tuple(lifts))


def steps(robot: str, seed: int) -> Recording:
    """The robot lifts each of its feet three times and puts it down, in an instant."""
    rng = np.random.default_rng([seed, 4])
    steps, time = [], 1.5
    for foot in np.tile(np.arange(4), 3):
        steps.append(Step(int(foot), time, rng.uniform(0.2, 0.3), rng.uniform(0.03, 0.05)))
        time += 1.6
    return Recording(robot, time, _contact_plant(seed), steps=tuple(steps))


def bias(robot: str, seed: int) -> Recording:
    """Ten seconds of standing with great biases, signs drawn, then roll, pitch and yaw."""
    signs = np.random.default_rng([seed, 3]).choice([-1.0, 1.0], 6)
    gyro, accelerometer = GYRO_BIAS * signs[:3], ACCELEROMETER_BIAS * signs[3:]
    flaws = Flaws(_three(gyro), _three(accelerometer))
    references, time = [], STILL
    for axis in ("roll", "pitch", "yaw"):
        for degrees in (SWAY_DEG, -SWAY_DEG, SWAY_DEG, -SWAY_DEG, 0.0):
            references.append(ReferenceRequest({axis: degrees}, time))
            time += _STEP
    plant = PlantSettings(seed=seed, flaws=flaws)
    return Recording(robot, time + 3.0, plant, references=tuple(references))


RECORDINGS: dict[str, Callable[[str, int], Recording]] = {
    "quiet": quiet,
    "quiet_long": quiet_long,
    "push60": push60,
    "shove": shove,
    "lifts": lifts,
    "feet": feet,
    "steps": steps,
    "bias": bias,
}


def _pushed(robot: str, seed: int, percent: float, duration: float) -> Recording:
    rng = np.random.default_rng([seed, 0])
    pushes = tuple(
        PushRequest(float(rng.uniform(-180.0, 180.0)), percent, True, 0.1, time)
        for time in PUSH_TIMES
    )
    flaws = Flaws(GYRO_SIGMA, ACCELEROMETER_SIGMA)
    return Recording(robot, duration, PlantSettings(seed=seed, flaws=flaws), pushes)


def _contact_plant(seed: int) -> PlantSettings:
    # The controller must know its contacts, or the robot would not outlive its hands; what the
    # estimator gets to see in the replay is another matter.
    return PlantSettings(seed=seed, foot_force="est")


def _three(values: np.ndarray) -> tuple[float, float, float]:
    x, y, z = (float(value) for value in values)
    return x, y, z
