# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import mujoco
import numpy as np
import pytest
from plant_helpers import ROBOTS, float_without_gravity, pd_command
from surefoot import Error
from surefoot.geometry.rotations import wxyz_from_rotation_vector
from surefoot.sim import Plant, PlantSettings, Push, Truth
from surefoot.sim.physics.standing_pose import HOLD_KD, HOLD_KP


def run(plant: Plant, seconds: float) -> Truth:
    # Use the gains of the initial pose: other gains would roll the feet slightly.
    cmd = pd_command(plant, kp=HOLD_KP, kd=HOLD_KD)
    for _ in range(round(seconds * plant.settings.control_rate)):
        plant.step(cmd)
    return plant.truth


@pytest.mark.parametrize("name", ROBOTS)
def test_feet_of_a_position_controlled_robot_creep_below_0_1_mm(name: str) -> None:
    plant = Plant(name)
    start = plant.truth.p_world_feet
    drift = np.linalg.norm(run(plant, 10.0).p_world_feet - start, axis=0)
    assert drift.max() < 0.1e-3


@pytest.mark.parametrize("name", ROBOTS)
def test_feet_sink_below_0_1_mm_into_rigid_ground(name: str) -> None:
    plant = Plant(name)
    heights = plant.truth.p_world_feet[2]
    sink = plant.robot.config.foot_radius - heights
    assert sink.min() > 0.0
    assert sink.max() < 0.1e-3


@pytest.mark.parametrize("name", ROBOTS)
@pytest.mark.parametrize("slope_deg", [0.0, 10.0])
def test_foot_forces_carry_the_weight(name: str, slope_deg: float) -> None:
    plant = Plant(name, PlantSettings(payload_kg=2.0, slope_deg=slope_deg, slope_heading_deg=40.0))
    truth = run(plant, 2.0)
    weight = (plant.robot.mass + 2.0) * 9.81
    np.testing.assert_allclose(
        truth.foot_forces.sum(axis=1), [0.0, 0.0, weight], atol=0.01 * weight
    )
    assert truth.contact.all()
    assert not truth.fell


def test_a_robot_on_a_slope_starts_parallel_to_it() -> None:
    plant = Plant("go1", PlantSettings(sensors="ideal", slope_deg=12.0, slope_heading_deg=90.0))
    normal = plant.handles.ground_normal
    heights = normal @ plant.truth.p_world_feet
    np.testing.assert_allclose(heights, plant.robot.config.foot_radius, atol=0.2e-3)
    up = plant.data.xmat[plant.handles.root].reshape(3, 3)[:, 2]
    assert np.degrees(np.arccos(up @ normal)) < 1.0
    assert normal[1] == pytest.approx(-np.sin(np.radians(12.0)))


def test_first_state_contains_standing_torques() -> None:
    plant = Plant("go1", PlantSettings(sensors="ideal"))
    state = plant.reset()
    calves = [state.motorState[i].tauEst for i in (2, 5, 8, 11)]
    assert min(calves) > 3.0
    np.testing.assert_allclose(calves, plant.truth.tau[2::3], rtol=1e-6)


def test_position_mode_holds_until_the_first_command_arrives() -> None:
    plant = Plant("go1")
    height = plant.truth.com[2]
    no_torque_state = plant.step(pd_command(plant, kp=0.0, kd=0.0))
    assert plant.truth.com[2] == pytest.approx(height, abs=1e-5)
    assert no_torque_state.motorState[2].tauEst > 3.0


def test_upright_collapse_without_torque_is_detected_as_fall() -> None:
    plant = Plant("go1", PlantSettings(sensors="ideal"))
    cmd = pd_command(plant, kp=0.0, kd=0.1)
    for _ in range(500):
        plant.step(cmd)
        if plant.truth.fell:
            break
    assert plant.truth.fell
    assert plant.truth.com[2] < 0.2
    assert plant.data.xmat[plant.handles.root].reshape(3, 3)[2, 2] > 0.8


def test_tilt_of_70_deg_is_a_fall_even_in_the_air() -> None:
    plant = Plant("go1", PlantSettings(sensors="ideal"))
    float_without_gravity(plant)
    for degrees, fallen in ((50.0, False), (70.0, True)):
        plant.data.qpos[3:7] = wxyz_from_rotation_vector([np.radians(degrees), 0.0, 0.0])
        mujoco.mj_step1(plant.model, plant.data)
        assert plant.truth.fell is fallen


@pytest.mark.parametrize(("friction", "least", "most"), [(0.8, 0.0, 5e-5), (0.25, 0.1, 5.0)])
def test_feet_slide_where_friction_is_less_than_the_slope(
    friction: float, least: float, most: float
) -> None:
    plant = Plant("go1", PlantSettings(friction=friction, slope_deg=20.0, slope_heading_deg=180.0))
    start = plant.truth.p_world_feet
    moved = np.linalg.norm(run(plant, 1.0).p_world_feet - start, axis=0).min()
    assert least <= moved <= most


def test_equal_seeds_give_equal_runs_and_other_seeds_do_not() -> None:
    def states(seed: int) -> bytes:
        plant = Plant("go1", PlantSettings(seed=seed, foot_force="est"))
        cmd = pd_command(plant)
        return b"".join(plant.step(cmd).to_bytes() for _ in range(20))

    assert states(4) == states(4)
    assert states(4) != states(5)


def test_reset_repeats_the_same_run() -> None:
    plant = Plant("a1", pushes=[Push("lateral", 3.0, 0.05, 0.02)])
    cmd = pd_command(plant)

    def run_again() -> bytes:
        plant.reset()
        return b"".join(plant.step(cmd).to_bytes() for _ in range(50))

    assert run_again() == run_again()


@pytest.mark.parametrize("direction", ["lateral", "forward"])
def test_half_the_physics_step_changes_sway_below_2_percent(direction: str) -> None:
    peaks = []
    for physics_dt in (0.0005, 0.00025):
        plant = Plant("go1", PlantSettings(physics_dt=physics_dt))
        plant.add_push(Push(direction, 0.5 * plant.lip_push_limit(direction), 0.1, 0.1))
        cmd, start = pd_command(plant), plant.truth.com
        path = []
        for _ in range(400):
            plant.step(cmd)
            path.append(plant.truth.com - start)
        peaks.append(np.linalg.norm(path, axis=1).max())
    assert peaks[0] > 0.02
    assert peaks[0] == pytest.approx(peaks[1], rel=0.02)


def test_slope_of_35_deg_is_refused_before_control_starts() -> None:
    with pytest.raises(Error, match=r"go1.*fell.*before.*slope 35 deg"):
        Plant("go1", PlantSettings(slope_deg=35.0))
