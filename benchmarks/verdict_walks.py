"""Healthy walks with turns, for sensor_verdicts.py; each differs for every robot and seed."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
from surefoot import Gait, WalkController, WalkVelocity
from surefoot.estimate import SensorLog, read_log, write_log
from surefoot.geometry.batch_rotations import matrices_from_xyzw, rpy_from_matrices
from surefoot.sim import Flaws, Plant, PlantSettings
from surefoot.sim.terrain import Terrain
from surefoot.stand import SensorRecorder

Command = Callable[[float], tuple[float, float, float]]  # vx, vy, yaw rate at a time [s]
PERIOD = 0.002  # [s] of the LowStates
TROT_TIME, WALK_TIME = 13.0, 18.0  # [s] duration of the motion; the gait walk turns slowly
MASS_ERROR, COM_ERROR = 0.05, 0.02  # relative error of the trunk mass; [m] of its centre
MIN_TURN = math.pi / 2.0  # [rad] smallest change of the heading of a log that is judged


def load_walk(folder: Path, robot: str, seed: int) -> SensorLog | None:
    """Return the log of a walk, recorded if it is missing; None if the robot falls or stays."""
    path = folder / f"{robot}-{seed}.npz"
    if not path.exists():
        folder.mkdir(parents=True, exist_ok=True)
        write_log(path, record_walk(robot, seed))
    log = read_log(path)
    return log if turn(log) >= MIN_TURN and log.time[-1] > TROT_TIME - 1.0 else None


def record_walk(robot: str, seed: int) -> SensorLog:
    """Simulate one walk and return its log; the robot may fall."""
    rng = np.random.default_rng([seed, 11])
    walks = seed % 5 == 3
    plant = Plant(robot, _plant(rng, seed))
    gains = plant.robot.config.gains
    if not walks:
        gains.gait_duty = float(rng.choice([0.5, 0.5, 0.6]))
    controller = WalkController(plant.robot, gains)
    controller.gait = Gait.WALK if walks else Gait.TROT
    start = float(rng.choice([0.0, 0.5, 1.5]))
    command = _draw_command(rng, walks)
    recorder, state = SensorRecorder(), plant.reset()
    for tick in range(int((start + (WALK_TIME if walks else TROT_TIME)) / PERIOD)):
        t = tick * PERIOD - start
        controller.set_velocity(WalkVelocity(*(command(t) if t >= 0.0 else (0.0, 0.0, 0.0))))
        motors, truth = controller.update(state), plant.truth
        state = plant.step(motors)
        recorder.record(state, truth)
        if plant.truth.fell:
            break
    return recorder.log(f"{robot}-{seed}")


def turn(log: SensorLog) -> float:
    """Return the range of the true heading [rad]."""
    rotation = matrices_from_xyzw(log.columns["truth_quaternion"][:, [1, 2, 3, 0]])
    return float(np.ptp(np.unwrap(rpy_from_matrices(rotation)[:, 2])))


def _plant(rng: np.random.Generator, seed: int) -> PlantSettings:
    """Return a plant: one of ten seeds has a slope, one blocks, one rigid soles."""
    kind = seed % 10
    ground: dict[str, object] = {}
    if kind == 5:
        slope, heading = rng.uniform(3.0, 8.0), rng.uniform(-180.0, 180.0)
        ground = {"slope_deg": float(slope), "slope_heading_deg": float(heading)}
    elif kind == 7:
        ground = {"terrain": Terrain(block_height=0.02, seed=seed)}
    friction = float(rng.uniform(0.5, 1.0))
    mass, shift = rng.uniform(-MASS_ERROR, MASS_ERROR), rng.uniform(-COM_ERROR, COM_ERROR, 3)
    foot_force = ("est", "raw", "dead")[int(rng.integers(3))]
    return PlantSettings(
        walking_sensors=kind != 8 or bool(rng.random() < 0.5),
        soft_soles=kind != 8,
        physics_dt=0.001,
        friction=friction,
        flaws=Flaws(trunk_mass_scale=1.0 + float(mass), trunk_com_shift=tuple(shift.tolist())),
        foot_force=foot_force,
        seed=seed,
        **ground,
    )


def _draw_command(rng: np.random.Generator, walks: bool) -> Command:
    """Return a command with one corner, an arc, or several turns."""
    v = float(rng.uniform(0.2, 1.0))
    vy = float(rng.uniform(-0.2, 0.2)) if rng.random() < 0.4 else 0.0
    rate = float(rng.uniform(0.4, 1.2) * rng.choice([-1, 1]))
    style = int(rng.integers(3))
    if walks:  # the gait limits the velocity
        return lambda t: (v, vy, rate if t > 4.0 else 0.0)
    if style == 0:
        return lambda t: _corner(t, v, vy, rate)
    if style == 1:
        return lambda t: (v, vy, 0.5 * rate if t > 2.0 else 0.0)
    return lambda t: (0.5 * v, vy, rate if t % 4.0 > 2.0 else 0.0)


def _corner(t: float, v: float, vy: float, rate: float) -> tuple[float, float, float]:
    if t < 3.0:
        return v, vy, 0.0
    return (0.0, 0.0, rate) if t < 3.0 + 1.8 * 0.5 * math.pi / abs(rate) else (v, 0.0, 0.0)
