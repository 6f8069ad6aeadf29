# SPDX-License-Identifier: BSD-3-Clause
"""Sensor matrix: a bare StandController whose sensor is wrong from the first sample.

    python benchmarks/sensor_matrix.py --robot go1 --jobs 2 --json FILE
    python benchmarks/sensor_matrix.py --robot go1 --healthy 200 --jobs 2

Each cell of the matrix is one sensor that is wrong in one way. The robot stands for 10 s, with two
pushes of 50 %. A cell passes if the controller names the sensor within 1 s, or when the robot first
moves, or if the robot stands to the end. It fails if another sensor is named, or if the robot falls
and the status was usable when the fall began. --healthy starts robots without any fault on random
ground, with random payload, noise and friction: no sensor may be named. tests/closed_loop has a
short form of both.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np
import surefoot
from seed_runs import ROBOTS, Job, RunOutcome, add_seed_options, parse_integer, run_seeds
from surefoot import LowState, StandController, Status
from surefoot.cli.output_files import write_json
from surefoot.faults.kinds.signals import Values, signal_view
from surefoot.sim import Flaws, Plant, PlantSettings, Push
from surefoot.sim.hardware import encoders, imu

DURATION = 10.0  # [s] of a cell
PUSHES = ((2.0, "lateral"), (6.0, "forward"))  # time [s] and direction; 50 % of the LIP push limit
NAMED_TIME = 1.0  # [s] longest time without a push until a wrong sensor is named
HEALTHY_DURATION = 3.0  # [s] of a healthy start
FALL_TILT = np.radians(10.0)  # [rad] a fall has begun when the tilt stays above this angle

SENSORS = {
    "quaternion": ("quaternion",),
    "gyroscope": ("gyroscope",),
    "accelerometer": ("accelerometer",),
    "q": ("q",),
    "dq": ("dq",),
    "tauEst": ("tauEst",),
    "footForce": ("footForce", "footForceEst"),
    "all joints": ("q", "dq", "tauEst"),
}
"""Fields of LowState that are wrong together, by the name of a row."""

NAMES = {
    "quaternion": {Status.BAD_QUATERNION},
    "gyroscope": {Status.WRONG_GYROSCOPE},
    "accelerometer": {Status.WRONG_ACCELEROMETER},
    "q": {Status.WRONG_JOINT_ANGLES},
    "dq": {Status.WRONG_JOINT_VELOCITIES},
    "tauEst": {Status.WRONG_JOINT_TORQUES},
    "footForce": set(),
    "all joints": {
        Status.WRONG_JOINT_ANGLES,
        Status.WRONG_JOINT_VELOCITIES,
        Status.WRONG_JOINT_TORQUES,
    },
}
"""Statuses that name the sensor of a row."""

Change = Callable[[str, Values, LowState], Values]
"""Function of the field's name, its true values and the sample that returns wrong values."""

PER_LEG = {"q", "dq", "tauEst", "footForce", "all joints"}
NOT_FOR_ALL_JOINTS = {"degrees", "g", "sign", "zero", "frozen"}  # other rows have them


@dataclass
class CellResult(RunOutcome):
    """Result of one cell; `why` says what is wrong with it."""

    text: str  # named, harmless or fell, with the time
    status: str  # fault() at the end


@dataclass
class HealthyStart(RunOutcome):
    """Result of one healthy start; `why` names the sensor that was found wrong."""

    fell: bool


def main() -> int:
    """Run the matrix or the healthy starts, print and write JSON; return 3 if anything failed."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--robot", default="go1", choices=ROBOTS)
    parser.add_argument("--healthy", type=lambda text: parse_integer(text, 1), metavar="COUNT")
    parser.add_argument("--slope", type=float, default=0.0, help="slope of the ground [deg] (0)")
    add_seed_options(parser)
    options = parser.parse_args()
    return run_healthy_starts(options) if options.healthy else run_matrix(options)


def run_matrix(options: argparse.Namespace) -> int:
    """Run every cell, print the matrix; return 3 if a cell failed."""
    cells = [(sensor, way) for sensor in SENSORS for way in ways_of(sensor)]
    jobs: list[Job] = [(options.robot, *cell, options.slope, options.first) for cell in cells]
    results = dict(zip(cells, run_seeds(run_cell, CellResult, jobs, options), strict=True))
    print(matrix_text(options.robot, results))
    failed = {" ".join(cell): result.why for cell, result in results.items() if not result.ok}
    table = {
        " ".join(cell): {"result": result.text, "status": result.status}
        for cell, result in results.items()
    }
    write_json(options.json, {"robot": options.robot, "cells": table, "failed": failed}, 1)
    return 3 if failed else 0


def run_healthy_starts(options: argparse.Namespace) -> int:
    """Run healthy starts; return 3 if a sensor was found wrong."""
    jobs: list[Job] = [(options.robot, options.first + k) for k in range(options.healthy)]
    runs = run_seeds(run_healthy, HealthyStart, jobs, options)
    alarms = {int(job[-1]): run.why for job, run in zip(jobs, runs, strict=True) if not run.ok}
    falls = sum(run.fell for run in runs)
    print(f"{options.robot}: {len(runs)} healthy starts, {len(alarms)} false alarms, {falls} falls")
    write_json(
        options.json,
        {"robot": options.robot, "starts": len(runs), "alarms": alarms, "falls": falls},
        1,
    )
    return 3 if alarms else 0


def ways_of(sensor: str) -> dict[str, Callable[[], Change]]:
    """Return the ways in which a sensor can be wrong: makers of the change, by name."""
    ways: dict[str, Callable[[], Change]] = {
        "degrees": lambda: scaled(180.0 / np.pi),
        "g": lambda: scaled(1.0 / 9.81),
        "sign": lambda: reversed_sign,
        "zero": lambda: scaled(0.0),
        "axes": lambda: swapped_axes,
        "left-right": lambda: swapped_legs([1, 0, 3, 2]),
        "front-rear": lambda: swapped_legs([2, 3, 0, 1]),
        "frozen": frozen,
        "no gravity": lambda: without_gravity,
    }
    if sensor not in PER_LEG:
        del ways["left-right"], ways["front-rear"]
    if sensor != "accelerometer":
        del ways["no gravity"]
    if sensor == "footForce":
        del ways["axes"]
    if sensor == "all joints":
        ways = {name: way for name, way in ways.items() if name not in NOT_FOR_ALL_JOINTS}
    return ways


def scaled(by: float) -> Change:
    """Return a change of unit."""
    return lambda field, values, state: values * by


def reversed_sign(field: str, values: Values, state: LowState) -> Values:
    """Reverse the sign; that of a quaternion's vector part: world to IMU."""
    return values * [1.0, -1.0, -1.0, -1.0] if field == "quaternion" else -values


def swapped_axes(field: str, values: Values, state: LowState) -> Values:
    """Order x y z as y z x, w x y z as x y z w, hip thigh calf as thigh hip calf."""
    if len(values) == 12:
        return values.reshape(4, 3)[:, [1, 0, 2]].ravel()
    return values[[*range(1, len(values)), 0]]


def swapped_legs(order: list[int]) -> Change:
    """Return a change of the order of legs."""
    return lambda field, values, state: values.reshape(4, -1)[order].ravel()


def frozen() -> Change:
    """Return a change that holds the first values."""
    held: dict[str, Values] = {}
    return lambda field, values, state: held.setdefault(field, values.copy())


def without_gravity(field: str, values: Values, state: LowState) -> Values:
    """Subtract gravity along the vertical of the quaternion: linear acceleration."""
    w, x, y, z = signal_view(state, "quaternion")
    up = np.array([2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)])
    return np.asarray(values - 9.81 * up)


def run_cell(job: Job) -> CellResult:
    """Let one robot stand with one sensor that is wrong in one way."""
    robot, sensor, way, slope, seed = job
    settings = PlantSettings(slope_deg=float(slope), slope_heading_deg=30.0, seed=int(seed))
    plant = Plant(str(robot), settings)
    for time, direction in PUSHES:
        plant.add_push(Push(direction, 0.5 * plant.lip_push_limit(direction), time=time))
    change = ways_of(str(sensor))[str(way)]()
    controller = StandController(plant.robot)
    state, usable, tilts = plant.reset(), list[bool](), list[float]()
    named: tuple[float, Status] | None = None
    while plant.time < DURATION and not plant.truth.fell:
        for field in SENSORS[str(sensor)]:
            values = signal_view(state, field)
            values[...] = change(field, values, state).astype(values.dtype)
        command = controller.update(state)
        status = controller.fault if controller.status == Status.DAMPING else controller.status
        if named is None and (status in NAMES[str(sensor)] or surefoot.names_wrong_sensor(status)):
            named = plant.time, status
        usable.append(surefoot.is_usable(controller.status))
        tilts.append(tilt(plant))
        state = plant.step(command)
    return judge(str(sensor), plant, named, usable, tilts, controller.fault.name)


def judge(
    sensor: str,
    plant: Plant,
    named: tuple[float, Status] | None,
    usable: list[bool],
    tilts: list[float],
    status: str,
) -> CellResult:
    """Return the result of a cell."""
    if named is not None:
        time, found = named
        text, right = f"named {time:.2f} s", found in NAMES[sensor]
        why = "" if right else f"named {found.name} at {time:.2f} s"
        fall_was_usable = usable[fall_onset(tilts)] and plant.truth.fell
        if fall_was_usable:
            why = f"named at {time:.2f} s, after the fall had begun"
        return CellResult(not why, why, text if not why else f"WRONG {text}", status)
    if not plant.truth.fell:
        return CellResult(True, "", "harmless", status)
    onset = fall_onset(tilts)
    why = f"fell at {plant.time:.2f} s with status {status}, usable at the onset: {usable[onset]}"
    return CellResult(not usable[onset], why, f"FELL {plant.time:.2f} s", status)


def fall_onset(tilts: list[float]) -> int:
    """Return the tick at which a fall began: the last one with a small tilt."""
    return int(np.flatnonzero(np.array(tilts) < FALL_TILT)[-1])


def tilt(plant: Plant) -> float:
    """Return the angle between the base and the ground [rad]."""
    x, y = plant.truth.q[3:5]
    return float(np.arccos(1.0 - 2.0 * (x * x + y * y)))


def run_healthy(job: Job) -> HealthyStart:
    """Start one robot without a fault; the seed draws ground, payload, noise and motors."""
    robot, seed = str(job[0]), int(job[1])
    rng = np.random.default_rng([seed, 13])
    mass = surefoot.load_robot(robot).mass
    settings = PlantSettings(
        seed=seed,
        friction=float(rng.choice([0.4, 0.8])),
        slope_deg=float(rng.uniform(0.0, 10.0)),
        slope_heading_deg=float(rng.uniform(-180.0, 180.0)),
        payload_kg=float(0.3 * mass * rng.uniform()),
        payload_position=(*(0.03 * rng.uniform(-1.0, 1.0, 2)).tolist(), 0.05),
        joint_friction_scale=float(rng.uniform(0.5, 2.0)),
        flaws=Flaws(trunk_mass_scale=float(rng.uniform(0.9, 1.1))),
    )
    with noise_scaled(float(rng.choice([1.0, 3.0]))):
        plant = Plant(robot, settings)
        if rng.uniform() < 0.5:
            plant.model.dof_damping[plant.handles.joint_v] = 2.0  # [N.m.s/rad]
        degrees = float(rng.uniform(-180.0, 180.0))
        impulse = float(rng.uniform(0.1, 0.3)) * plant.lip_push_limit(degrees)
        plant.add_push(Push(degrees, impulse, time=float(rng.uniform(0.2, 2.0))))
        state = plant.reset()
    controller = StandController(plant.robot)
    while plant.time < HEALTHY_DURATION and not plant.truth.fell:
        state = plant.step(controller.update(state))
    found = surefoot.names_wrong_sensor(controller.fault)
    return HealthyStart(not found, controller.fault.name if found else "", plant.truth.fell)


@contextmanager
def noise_scaled(by: float) -> Iterator[None]:
    """Scale noise and bias of IMU and encoders of the plants that are built and reset inside."""
    names = {
        imu: ("GYRO_NOISE", "GYRO_BIAS", "ACCELEROMETER_NOISE", "ACCELEROMETER_BIAS"),
        encoders: ("VELOCITY_NOISE",),
    }
    values = {(m, name): getattr(m, name) for m, group in names.items() for name in group}
    try:
        for (module, name), value in values.items():
            setattr(module, name, by * value)
        yield
    finally:
        for (module, name), value in values.items():
            setattr(module, name, value)


def matrix_text(robot: str, results: dict[tuple[str, str], CellResult]) -> str:
    """Return the matrix as text: a row per sensor, a column per way."""
    columns = list(dict.fromkeys(way for _, way in results))
    rows = [["", *columns]]
    for sensor in SENSORS:
        cells = [results.get((sensor, way)) for way in columns]
        rows.append([sensor, *("-" if cell is None else cell.text for cell in cells)])
    widths = [max(len(row[k]) for row in rows) for k in range(len(columns) + 1)]
    lines = [
        "  ".join(text.ljust(width) for text, width in zip(row, widths, strict=True))
        for row in rows
    ]
    return "\n".join([robot, *(line.rstrip() for line in lines)])


if __name__ == "__main__":
    sys.exit(main())
