# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import mujoco
import numpy as np
import pytest
import surefoot
from plant_helpers import ROBOTS, pd_command
from surefoot.sim import Plant, PlantSettings, Push
from surefoot.sim.physics.standing_pose import HOLD_KD, HOLD_KP


def plant_after_pd_hold(name: str, seconds: float, settings: PlantSettings) -> Plant:
    """Return a plant after some time under PD hold."""
    plant = Plant(name, settings)
    cmd = pd_command(plant, HOLD_KP, HOLD_KD)
    for _ in range(round(seconds * plant.settings.control_rate)):
        plant.step(cmd)
    return plant


def foot_depths(plant: Plant) -> np.ndarray:
    """Return how deep each foot is in the ground [m]."""
    return plant.robot.config.foot_radius - plant.handles.ground_normal @ plant.truth.p_world_feet


def test_zero_sink_uses_rigid_ground() -> None:
    model = Plant("go1", PlantSettings(soft_ground_sink=0.0)).model
    assert model.npair == 0
    assert model.opt.impratio == 100.0


@pytest.mark.parametrize("name", ROBOTS)
@pytest.mark.parametrize("sink", [0.001, 0.01, 0.04])
def test_standing_robot_sinks_to_the_set_depth(name: str, sink: float) -> None:
    plant = plant_after_pd_hold(name, 1.0, PlantSettings(soft_ground_sink=sink))
    assert foot_depths(plant).mean() == pytest.approx(sink, rel=0.01)
    assert (
        np.abs(foot_depths(plant) / sink - 1.0).max() < 0.25
    )  # feet do not share the weight evenly
    assert plant.data.ncon == 4
    assert plant.truth.contact.all() and not plant.truth.fell


@pytest.mark.parametrize("name", ["go1", "b1"])
def test_each_foot_is_a_linear_spring(name: str) -> None:
    sink = 0.01
    plant = plant_after_pd_hold(name, 1.0, PlantSettings(soft_ground_sink=sink, payload_kg=3.0))
    stiffness = plant.robot.mass * 9.81 / 4.0 / sink
    np.testing.assert_allclose(
        foot_depths(plant), plant.truth.foot_forces[2] / stiffness, rtol=0.01
    )


@pytest.mark.parametrize("name", ["go1", "b1"])
@pytest.mark.parametrize("physics_dt", [0.0005, 0.00025])
def test_released_robot_settles_critically_damped(name: str, physics_dt: float) -> None:
    sink = 0.02
    plant = plant_after_pd_hold(
        name, 0.5, PlantSettings(soft_ground_sink=sink, physics_dt=physics_dt)
    )
    stiff = pd_command(plant, 4.0 * HOLD_KP, 2.0 * HOLD_KD)
    for _ in range(200):
        plant.step(stiff)
    rest = foot_depths(plant).mean()
    plant.data.qpos[2] += 0.5 * sink
    mujoco.mj_step1(plant.model, plant.data)
    path = []
    for _ in range(200):
        plant.step(stiff)
        path.append((rest - foot_depths(plant).mean()) / (0.5 * sink))
    phase = np.sqrt(9.81 / sink) * 0.002 * np.arange(1, 201)
    np.testing.assert_allclose(path, (1.0 + phase) * np.exp(-phase), atol=0.03)


@pytest.mark.parametrize("name", ROBOTS)
def test_feet_on_soft_ground_do_not_creep(name: str) -> None:
    plant = plant_after_pd_hold(name, 0.5, PlantSettings(soft_ground_sink=0.01))
    start = plant.truth.p_world_feet
    cmd = pd_command(plant, HOLD_KP, HOLD_KD)
    for _ in range(1000):
        plant.step(cmd)
    assert np.linalg.norm(plant.truth.p_world_feet - start, axis=0).max() < 0.1e-3


@pytest.mark.parametrize("sink", [0.001, 0.01, 0.03])
def test_feet_on_a_soft_slope_slide_with_coulomb_friction(sink: float) -> None:
    slope = np.radians(20.0)
    settings = PlantSettings(
        friction=0.25, slope_deg=20.0, slope_heading_deg=180.0, soft_ground_sink=sink
    )
    plant = plant_after_pd_hold("go1", 0.25, settings)
    before = np.linalg.norm(plant.truth.com_velocity)
    cmd = pd_command(plant, HOLD_KP, HOLD_KD)
    for _ in range(125):
        plant.step(cmd)
    gained = np.linalg.norm(plant.truth.com_velocity) - before
    assert gained / 0.25 == pytest.approx(9.81 * (np.sin(slope) - 0.25 * np.cos(slope)), rel=0.02)
    assert abs(foot_depths(plant).mean() - sink * np.cos(slope)) < 0.1 * sink + 0.001


def test_feet_on_a_soft_slope_hold_where_friction_suffices() -> None:
    settings = PlantSettings(slope_deg=20.0, slope_heading_deg=180.0, soft_ground_sink=0.01)
    plant = plant_after_pd_hold("go1", 0.5, settings)
    assert np.linalg.norm(plant.truth.com_velocity) < 1e-3
    np.testing.assert_allclose(
        foot_depths(plant).mean(), 0.01 * np.cos(np.radians(20.0)), rtol=0.01
    )


def test_collapse_on_soft_ground_is_detected_as_fall() -> None:
    plant = Plant("go1", PlantSettings(sensors="ideal", soft_ground_sink=0.01))
    no_torque = pd_command(plant, kp=0.0, kd=0.1)
    for _ in range(500):
        plant.step(no_torque)
    assert plant.truth.fell
    assert np.isfinite(plant.data.qpos).all()


def test_half_the_physics_step_changes_sway_on_soft_ground_below_2_percent() -> None:
    peaks = []
    for physics_dt in (0.0005, 0.00025):
        plant = Plant("go1", PlantSettings(physics_dt=physics_dt, soft_ground_sink=0.01))
        plant.add_push(Push("lateral", 0.5 * plant.lip_push_limit("lateral"), 0.1, 0.1))
        cmd, start, path = pd_command(plant), plant.truth.com, []
        for _ in range(200):
            plant.step(cmd)
            path.append(plant.truth.com - start)
        peaks.append(np.linalg.norm(path, axis=1).max())
    assert peaks[0] > 0.02
    assert peaks[0] == pytest.approx(peaks[1], rel=0.02)


def test_sink_below_rigid_ground_penetration_is_refused() -> None:
    with pytest.raises(surefoot.Error, match=r"soft_ground_sink: got 1e-05, expected 0 .*0\.0001"):
        PlantSettings(soft_ground_sink=1e-5)
