"""Case payload: figures of unknown payloads in closed loop."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from surefoot import Error, StandController
from surefoot.geometry.rotations import matrix_from_wxyz
from surefoot.sim import Flaws, Plant, PlantSettings

from estimation.metrics import Result, Values

PAYLOAD_SHARES = (-0.2, 0.2, 0.4)  # payloads as shares of the robot's mass; < 0: a lighter trunk
COM_SHIFT = 0.03  # [m] shift of the whole robot's centre of mass
DURATION, JUDGED_TIME = 3.0, 0.2  # [s] duration of a run, and of its evaluated end
A1_PAYLOAD = 11.0  # [kg] payload of the a1
MAX_HEIGHT_ERROR = 0.02  # [m] largest height error that counts as standing
PAYLOAD_RESOLUTION = 0.25  # [kg] resolution of the largest payload


@dataclass(frozen=True)
class StandResult:
    """State at the end of a run.

    Attributes:
        fell: True if the robot fell, or could not start.
        height: Mean height error at the end [m], relative to the start of the controller.
        tilt: Mean tilt error at the end [rad], relative to the start of the controller.
        payload: Estimated payload [kg].
    """

    fell: bool
    height: float
    tilt: float
    payload: float


def payload(robot: str, seed: int) -> Result:
    """Evaluate the errors with each payload, and the largest payload (seed 0 only)."""
    values: Values = {"fell": 0.0}
    mass = Plant(robot, PlantSettings()).robot.mass
    for share in PAYLOAD_SHARES:
        stand = run_stand(robot, loaded_plant(robot, share * mass, seed, COM_SHIFT))
        label = f"{100 * share:+.0f} %"
        mass_error = abs(stand.payload - share * mass) / (abs(share) * mass)
        values["fell"] += float(stand.fell)
        values[f"height error: {label}"] = 1000.0 * stand.height
        values[f"tilt error: {label}"] = math.degrees(stand.tilt)
        values[f"mass error: {label}"] = 100.0 * mass_error if stand.payload else math.nan
    if robot == "a1":
        stand = run_stand(robot, loaded_plant(robot, A1_PAYLOAD, seed, 0.0))
        values["fell"] += float(stand.fell)
        values["11 kg, height error"] = 1000.0 * stand.height
    if seed == 0:
        values["greatest payload"] = max_payload(robot, mass)
    return Result(values)


def loaded_plant(robot: str, kilograms: float, seed: int, shift: float) -> PlantSettings:
    """Return settings of a plant with a payload or a lighter trunk, and a shifted centre of mass.

    The payload is on the trunk. The trunk's centre of mass moves in a random direction, so far that
    the whole robot's centre of mass moves by `shift` [m].
    """
    nominal = Plant(robot, PlantSettings())
    doubled = Plant(robot, PlantSettings(flaws=Flaws(trunk_mass_scale=2.0)))
    masses = [float(p.model.body_subtreemass[p.handles.root]) for p in (nominal, doubled)]
    trunk = masses[1] - masses[0]
    scale = 1.0 + min(kilograms, 0.0) / trunk
    angle = np.random.default_rng([seed, 5]).uniform(0.0, 2.0 * math.pi)
    length = shift * (masses[0] + kilograms) / (scale * trunk)
    direction = (length * math.cos(angle), length * math.sin(angle), 0.0)
    flaws = Flaws(trunk_mass_scale=scale, trunk_com_shift=direction)
    return PlantSettings(seed=seed, payload_kg=max(kilograms, 0.0), flaws=flaws)


def max_payload(robot: str, mass: float) -> float:
    """Return the largest payload [kg] with which the robot stands for three seconds.

    The payload is found by bisection.
    """
    low, high = 0.0, 3.0 * mass
    while high - low > PAYLOAD_RESOLUTION:
        middle = 0.5 * (low + high)
        stand = run_stand(robot, loaded_plant(robot, middle, 0, 0.0))
        if stand.fell or stand.height > MAX_HEIGHT_ERROR:
            high = middle
        else:
            low = middle
    return low


def run_stand(robot: str, settings: PlantSettings) -> StandResult:
    """Stand for three seconds and return the final errors."""
    try:
        plant = Plant(robot, settings)
    except Error:  # the robot fell before the controller started
        return StandResult(True, math.inf, math.pi, 0.0)
    controller = StandController(plant.robot, plant.robot.config.gains)
    state = plant.reset()
    first_height, first_up = _pose(plant)
    rows = []
    ticks = round(DURATION * settings.control_rate)
    for _ in range(ticks):
        state = plant.step(controller.update(state))
        if plant.truth.fell:
            return StandResult(True, math.inf, math.pi, 0.0)
        height, up = _pose(plant)
        rows.append((height - first_height, float(np.arccos(np.clip(up @ first_up, -1, 1)))))
    height_error, tilt = np.mean(rows[-round(JUDGED_TIME * settings.control_rate) :], axis=0)
    mass = float(controller.estimator_report.payload)
    return StandResult(False, abs(float(height_error)), float(tilt), mass)


def _pose(plant: Plant) -> tuple[float, np.ndarray]:
    """Return the height of the base above its feet [m] and world z in base axes (3,)."""
    data, handles = plant.data, plant.handles
    feet = data.xpos[handles.foot_bodies, 2].mean()
    return float(data.qpos[2] - feet), matrix_from_wxyz(data.qpos[3:7])[2].copy()
