"""Comparison of a plant's MuJoCo model with the controller's Pinocchio model."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np

from surefoot._core import Robot
from surefoot.geometry.rotations import Array
from surefoot.robot.loading import RobotDescription
from surefoot.sim.model.mujoco_model import build_model
from surefoot.sim.pinocchio_adapter import PinocchioAdapter
from surefoot.sim.settings import PlantSettings


@dataclass(frozen=True)
class Agreement:
    """Largest differences of the two models, each as a share of the quantity's largest entry."""

    mass_matrix: float
    gravity: float
    feet: float

    @property
    def worst(self) -> float:
        """The largest of the three; NaN if one is NaN."""
        return float(np.max([self.mass_matrix, self.gravity, self.feet]))


def compare_models(
    robot: Robot, description: RobotDescription, seed: int = 0, poses: int = 3
) -> Agreement:
    """Compare mass matrix, gravity terms and foot positions, with armature in both models.

    Args:
        robot: The robot as the controller knows it.
        description: The files from which the plant is built.
        seed: Seed of the random poses.
        poses: Number of random poses about the standing pose, besides the standing pose itself.

    Raises:
        Error: A mesh is missing, or MuJoCo rejects the URDF.
    """
    import pinocchio

    model = pinocchio.Model()
    model.loadFromString(robot.serialized_model())
    plant = build_model(robot, description, PlantSettings())
    rng, q = np.random.default_rng(seed), robot.q_standing()
    worst = np.zeros(3)
    for pose in range(poses + 1):
        if pose > 0:
            q = pinocchio.integrate(model, q, rng.uniform(-0.7, 0.7, model.nv))
        worst = np.maximum(worst, _differences(model, plant, robot, q))
    return Agreement(*map(float, worst))


def _differences(model: Any, plant: mujoco.MjModel, robot: Robot, q: Array) -> Array:
    import pinocchio

    adapter, data, state = PinocchioAdapter(plant, model), model.createData(), mujoco.MjData(plant)
    state.qpos[:] = adapter.qpos_from_pinocchio(q)
    mujoco.mj_forward(plant, state)
    matrix = np.zeros((plant.nv, plant.nv))
    mujoco.mj_fullM(plant, state, matrix)
    T = adapter.velocity_map(q)
    crba = np.triu(pinocchio.crba(model, data, q))
    ours = [crba + np.triu(crba, 1).T, pinocchio.computeGeneralizedGravity(model, data, q)]
    pinocchio.framesForwardKinematics(model, data, q)
    ours.append(np.array([data.oMf[frame].translation for frame in robot.foot_frame_ids]))
    bodies = [plant.body(name).id for name in robot.config.foot_frames]
    theirs = [T.T @ matrix @ T, T.T @ state.qfrc_bias, state.xpos[bodies]]
    return np.array([abs(a - b).max() / abs(a).max() for a, b in zip(ours, theirs, strict=True)])
