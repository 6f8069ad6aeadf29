"""What all runs of a matrix have in common: the robot, where it lies, what is put to the test."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from surefoot._core import Robot, Supervisor, SupervisorOptions
from surefoot.geometry.rotations import Array
from surefoot.robot.description import RobotDescription
from surefoot.sim import Plant, PlantSettings
from surefoot.sim.settings import COARSE_DT

_LYING_RNG_STREAM = 99  # stream of the random numbers that draw the lying pose


@dataclass(frozen=True)
class MatrixSetup:
    """What all scenes of a matrix have in common.

    Attributes:
        description: The robot.
        seed: Of sensors, motors and the lying pose.
        lying_qpos: MuJoCo's qpos of the robot at rest.
        standing_height: Of the standing base [m].
        make_supervisor: Makes what is put to the test.
        taken_over: The robot stands from the start, and is taken over so.
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
    """Drop a robot until it lies well, and return the setup; raises Error."""
    plant = Plant(description, PlantSettings(seed=seed, physics_dt=COARSE_DT))
    height = float(plant.data.qpos[2])
    plant.reset_lying(np.random.default_rng([seed, _LYING_RNG_STREAM]))
    lying = plant.data.qpos.copy()
    return MatrixSetup(
        description, seed, lying, height, make_supervisor or default_supervisor, taken_over
    )


def default_supervisor(robot: Robot, options: SupervisorOptions) -> Supervisor:
    """Return the supervisor as everybody gets it."""
    return Supervisor(robot, options=options)
