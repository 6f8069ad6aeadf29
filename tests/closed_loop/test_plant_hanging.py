# SPDX-License-Identifier: BSD-3-Clause
"""A hung robot, compared with the same robot on a fixed base."""

from __future__ import annotations

import copy

import mujoco
import numpy as np
import pytest
import surefoot
from plant_helpers import ROBOTS
from surefoot.sim import Plant, PlantSettings
from surefoot.sim.model import urdf_scene
from surefoot.sim.model.mujoco_model import build_model
from surefoot.sim.model.urdf import load_urdf, root_body


def harsh_command(rng: np.random.Generator) -> surefoot.LowCmd:
    """Return a random command with extreme values, mostly against joint limits and the trunk."""
    cmd = surefoot.LowCmd()
    for i in range(12):
        motor = cmd.motorCmd[i]
        motor.mode = int(rng.choice([0x00, 0x0A, 0x0A, 0x0A]))
        motor.q = float(rng.choice([0.0, 3.0, -3.0, 1e8, -1e8, surefoot.PosStopF]))
        motor.dq = float(rng.choice([0.0, 30.0, -30.0, 1e4, surefoot.VelStopF]))
        motor.tau = float(rng.choice([0.0, 127.0, -127.0, 5.0]))
        motor.Kp = float(rng.choice([0.0, 5.0, 400.0, 2047.0]))
        motor.Kd = float(rng.choice([0.0, 1.0, 20.0, 4095.0]))
    return cmd


def without_base(plant: Plant, monkeypatch: pytest.MonkeyPatch) -> mujoco.MjModel:
    """Return the plant's model with its base fixed to the world where it hangs."""

    def load(description):
        spec = load_urdf(description)
        for joint in list(root_body(spec).joints):
            spec.delete(joint)
        return spec

    with monkeypatch.context() as patch:
        patch.setattr(urdf_scene, "load_urdf", load)
        model = build_model(plant.robot, plant.description, plant.settings)
    root = plant.handles.root
    model.body_pos[root], model.body_quat[root] = plant.data.qpos[:3], plant.data.qpos[3:7]
    # These weights set the stiffness of contacts and limits: use those of the free base.
    model.body_invweight0[:] = plant.model.body_invweight0
    model.dof_invweight0[:] = plant.model.dof_invweight0[6:]
    return model


def acceleration_error(plant: Plant, fixed: mujoco.MjModel, data: mujoco.MjData) -> float:
    """Return the largest joint acceleration error over the largest acceleration."""
    hung = copy.copy(plant.data)
    data.qpos[:], data.qvel[:] = hung.qpos[7:], hung.qvel[6:]
    data.qfrc_applied[:] = hung.qfrc_applied[6:]
    mujoco.mj_forward(plant.model, hung)
    mujoco.mj_forward(fixed, data)
    difference = np.abs(hung.qacc[6:] - data.qacc).max()
    return float(difference / (1.0 + np.abs(data.qacc).max()))


@pytest.mark.parametrize("name", ROBOTS)
def test_hung_legs_move_like_a_fixed_base_robot_under_any_command(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    plant = Plant(name, PlantSettings(hung=True, control_rate=1000.0))
    home = plant.data.qpos[:7].copy()
    fixed = without_base(plant, monkeypatch)
    data = mujoco.MjData(fixed)
    rng = np.random.default_rng(0)
    errors, speeds = [], []
    for _ in range(40):
        cmd = harsh_command(rng)
        for _ in range(50):
            plant.step(cmd)
            errors.append(acceleration_error(plant, fixed, data))
            speeds.append(np.abs(plant.data.qvel).max())
    assert np.median(errors) < 1e-4
    assert np.percentile(errors, 99) < 0.02
    assert max(speeds) < 100.0  # [rad/s]; the largest no-load speed is 30
    np.testing.assert_allclose(plant.data.qpos[:7], home, rtol=0.0, atol=1e-8)
    assert np.abs(plant.data.qacc[:6]).max() < 1e-3
