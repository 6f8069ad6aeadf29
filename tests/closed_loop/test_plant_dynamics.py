# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import mujoco
import numpy as np
import pinocchio
import pytest
from plant_helpers import ROBOTS
from surefoot.robot.loading import build_robot, describe_robot
from surefoot.sim.model.mujoco_model import build_model
from surefoot.sim.pinocchio_adapter import PinocchioAdapter
from surefoot.sim.settings import PlantSettings

REPAIRED = ("go1", "b1")  # all inertia entries of their base link are 1e-6: MuJoCo refuses them


class Pair:
    """One robot as a Pinocchio model and as a MuJoCo model."""

    def __init__(self, name: str) -> None:
        description = describe_robot(name)
        robot = build_robot(description)
        self.pin = pinocchio.Model()
        self.pin.loadFromString(robot.serialized_model())
        self.mj = build_model(robot, description, PlantSettings())
        self.adapter = PinocchioAdapter(self.mj, self.pin)
        self.pin_data, self.mj_data = self.pin.createData(), mujoco.MjData(self.mj)

    def compare(self, rng: np.random.Generator) -> tuple[float, float]:
        """Return the largest differences of mass matrix and bias at a random state."""
        nq, nv = self.pin.nq, self.pin.nv
        q = pinocchio.randomConfiguration(self.pin, -np.ones(nq), np.ones(nq))
        v = rng.normal(size=nv)
        self.mj_data.qpos[:] = self.adapter.qpos_from_pinocchio(q)
        self.mj_data.qvel[:] = self.adapter.qvel_from_pinocchio(q, v)
        mujoco.mj_forward(self.mj, self.mj_data)
        mass = np.zeros((nv, nv))
        mujoco.mj_fullM(self.mj, self.mj_data, mass)
        # M_pin = T' M T, and h_pin = T' (h + M dT/dt v), for qvel = T v.
        T, drift = self.adapter.velocity_map(q), self.adapter.velocity_map_drift(q, v)
        bias = T.T @ (self.mj_data.qfrc_bias + mass @ drift)
        crba = np.triu(pinocchio.crba(self.pin, self.pin_data, q))
        expected = crba + np.triu(crba, 1).T
        nle = pinocchio.nle(self.pin, self.pin_data, q, v)
        return float(abs(expected - T.T @ mass @ T).max()), float(abs(nle - bias).max())


def repair(pin: pinocchio.Model) -> None:
    base = pin.inertias[1]
    inertia = base.inertia - 1e-6 * (np.ones((3, 3)) - np.eye(3))
    pin.inertias[1] = pinocchio.Inertia(base.mass, base.lever, inertia)


@pytest.mark.parametrize("name", ROBOTS)
def test_mass_matrix_and_bias_match_pinocchio(name: str) -> None:
    pair, rng = Pair(name), np.random.default_rng(1)
    pinocchio.seed(1)
    if name in REPAIRED:
        repair(pair.pin)
    for _ in range(10):
        mass_error, bias_error = pair.compare(rng)
        assert mass_error < 1e-9
        assert bias_error < 1e-9


@pytest.mark.parametrize("name", REPAIRED)
def test_inertia_repair_changes_the_mass_matrix_by_1e_minus_6(name: str) -> None:
    pair, rng = Pair(name), np.random.default_rng(2)
    pinocchio.seed(2)
    worst = max(pair.compare(rng)[0] for _ in range(5))
    assert 0.5e-6 < worst < 1.001e-6


@pytest.mark.parametrize("name", ROBOTS)
def test_armature_of_the_configuration_is_in_the_model(name: str) -> None:
    pair = Pair(name)
    robot = build_robot(describe_robot(name))
    dofs = [pair.mj.joint(joint).dofadr[0] for joint in robot.config.joint_names]
    np.testing.assert_allclose(pair.mj.dof_armature[dofs], robot.config.armature)
    assert pair.mj.dof_armature[:6].max() == 0.0


def test_scales_multiply_armature_and_joint_friction() -> None:
    description = describe_robot("go1")
    robot = build_robot(description)
    settings = PlantSettings(armature_scale=3.0, joint_friction_scale=0.5)
    joint = build_model(robot, description, settings).joint("FL_calf_joint")
    assert joint.armature[0] == pytest.approx(3.0 * 0.00906)
    assert joint.frictionloss[0] == pytest.approx(0.5 * 0.2)
    assert joint.damping[0] == pytest.approx(0.5 * 0.01)


def test_payload_adds_its_mass_at_its_position() -> None:
    description = describe_robot("go2")
    robot = build_robot(description)
    settings = PlantSettings(payload_kg=4.0, payload_position=(0.1, -0.05, 0.08))
    plain = build_model(robot, description, PlantSettings())
    loaded = build_model(robot, description, settings)
    assert loaded.body_subtreemass[0] == pytest.approx(robot.mass + 4.0)
    centres = []
    for model in (plain, loaded):
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
        centres.append(data.subtree_com[0] * model.body_subtreemass[0])
    np.testing.assert_allclose(centres[1] - centres[0], [0.4, -0.2, 0.32], atol=1e-12)
