"""Common setup of all cells of a matrix: robot, lying pose, and supervisor under test."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from surefoot._core import Robot, Supervisor, SupervisorOptions
from surefoot.geometry.rotations import Array
from surefoot.robot.description import RobotDescription
from surefoot.sim import Plant, PlantSettings
from surefoot.sim.settings import COARSE_DT

_LYING_RNG_STREAM = 99  # number of the random stream for the lying pose; the plant uses 0 .. 3


@dataclass(frozen=True)
class MatrixSetup:
    """Common setup of all cells of a matrix.

    Attributes:
        description: Description of the robot.
        seed: Seed of sensors, motors and the lying pose.
        lying_qpos: MuJoCo qpos of the robot lying at rest.
        standing_height: Height of the standing base [m].
        make_supervisor: Function that constructs the supervisor under test.
        taken_over: True: the robot stands when the supervisor starts.
    """

    description: RobotDescription
    seed: int
    lying_qpos: Array
    standing_height: float
    make_supervisor: Callable[[Robot, SupervisorOptions], Supervisor]
    taken_over: bool = False


def make_setup(
    description: RobotDescription,
    seed: int,
    make_supervisor: Callable[[Robot, SupervisorOptions], Supervisor] | None = None,
    taken_over: bool = False,
) -> MatrixSetup:
    """Drop a robot, wait until it lies at rest, and return the setup.

    Args:
        description: Description of the robot.
        seed: Seed of sensors, motors and the lying pose.
        make_supervisor: Function that constructs the supervisor; None: default_supervisor.
        taken_over: True: the robot stands when the supervisor starts.

    Raises:
        Error: The description is invalid.
    """
    plant = Plant(description, PlantSettings(seed=seed, physics_dt=COARSE_DT))
    height = float(plant.data.qpos[2])
    plant.reset_lying(np.random.default_rng([seed, _LYING_RNG_STREAM]))
    lying = plant.data.qpos.copy()
    return MatrixSetup(
        description, seed, lying, height, make_supervisor or default_supervisor, taken_over
    )


def default_supervisor(robot: Robot, options: SupervisorOptions) -> Supervisor:
    """Construct a supervisor with the robot's own gains."""
    return Supervisor(robot, options=options)
