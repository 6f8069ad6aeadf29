# SPDX-License-Identifier: BSD-3-Clause
"""A walk of a go1 with the sensor errors, soles and collisions that walking adds."""

from __future__ import annotations

from dataclasses import replace

import mujoco
import numpy as np
import pytest
import surefoot
from surefoot.sim import Plant, PlantSettings, Push
from surefoot.walk import FIELDS, WalkLog, WalkSettings, parse_velocity, run_walk, summarise
from surefoot.walk.slip import slip_velocities

pytestmark = pytest.mark.slow

VELOCITIES = ("0.5,0,0@0.5", "0.3,0,1@3.5", "0,0,0@6.5")
# Largest figures of the worst command: mean error and RMSE of vx, vy [m/s] and of the yaw rate
# [rad/s], RMS of roll and pitch [deg].
TARGET = {"mean": [0.02, 0.02, 0.02], "rmse": [0.05, 0.05, 0.1], "roll_pitch": [1.0, 1.0]}


def walk(**plant: bool) -> WalkLog:
    """Walk forward, turn, and stop; `plant` changes settings of the default plant."""
    velocities = tuple(map(parse_velocity, VELOCITIES))
    settings = WalkSettings(duration=10.0, velocities=velocities)
    return run_walk(replace(settings, plant=replace(settings.plant, **plant)))


@pytest.fixture(scope="module")
def log() -> WalkLog:
    return walk()


@pytest.fixture(scope="module")
def summary(log: WalkLog) -> dict:
    return summarise(log)


@pytest.fixture(scope="module")
def quiet_summary() -> dict:
    """The same walk, without the sensor errors that walking adds."""
    return summarise(walk(walking_sensors=False))


def check_walk(summary: dict, bounds: dict[str, list[float]]) -> None:
    assert not summary["fell"]
    assert (summary["failed_ticks"], summary["leg_contacts"]) == (0, 0)
    assert summary["torque_mode_only"]
    assert np.all(np.array(summary["velocity_mean_error"]) <= bounds["mean"])
    assert np.all(np.array(summary["velocity_rmse"]) <= bounds["rmse"])
    assert np.all(np.array(summary["roll_pitch_rms_deg"]) <= bounds["roll_pitch"])


def test_go1_walks_and_turns_at_the_commanded_velocity(quiet_summary) -> None:
    check_walk(quiet_summary, TARGET)


def test_go1_walks_and_turns_with_walking_sensors(summary) -> None:
    check_walk(summary, TARGET)


def test_go1_stops_and_stands_within_2_cm_of_its_standing_pose(quiet_summary) -> None:
    assert quiet_summary["stands_at_end"]
    assert quiet_summary["stance_error_mm"] <= 20.0


def test_go1_stops_and_stands_with_walking_sensors(summary) -> None:
    assert summary["stance_error_mm"] <= 20.0
    assert summary["stands_at_end"]


def test_summary_has_every_field_in_order(summary) -> None:
    assert list(summary) == [field.name for field in FIELDS]


def test_figures_of_a_command_leave_out_its_first_second(log, summary) -> None:
    command, velocity = summary["commands"][1], log.com_velocity
    assert (command["velocity"], command["time"]) == ([0.3, 0.0, 1.0], 3.5)
    rows = slice(2250, 3250)  # 4.5 s to 6.5 s at 500 Hz
    turned = np.unwrap(2.0 * np.arctan2(log.q_true[:, 5], log.q_true[:, 6]))  # small roll, pitch
    rate = (turned[rows.stop] - turned[rows.start]) / 2.0
    assert command["velocity_mean_error"][2] == pytest.approx(abs(rate - 1.0), abs=0.005)
    forward = (
        np.cos(turned[rows]) * velocity[rows, 0] + np.sin(turned[rows]) * velocity[rows, 1]
    ).mean()
    assert command["velocity_mean_error"][0] == pytest.approx(abs(forward - 0.3), abs=0.005)


def test_rolling_is_no_slip_and_a_sliding_foot_slips() -> None:
    plant = Plant("go1", PlantSettings(sensors="ideal"))
    plant.reset()
    plant.data.qvel[:] = 0.0
    plant.data.qvel[0] = 0.2  # the whole robot slides forward
    update_velocities(plant)
    np.testing.assert_allclose(slip_velocities(plant)[0], 0.2, atol=1e-9)
    # The base turns about the lowest point of a foot: the foot rolls.
    radius, foot = plant.robot.config.foot_radius, plant.truth.p_world_feet[:, 0]
    plant.data.qvel[:] = 0.0
    R = plant.data.xmat[plant.handles.root].reshape(3, 3)
    omega, point = np.array([0.0, 1.0, 0.0]), foot - [0.0, 0.0, radius]
    plant.data.qvel[:3] = np.cross(omega, plant.data.qpos[:3] - point)
    plant.data.qvel[3:6] = R.T @ omega
    update_velocities(plant)
    assert abs(slip_velocities(plant)[:, 0]).max() < 1e-4
    assert slip_velocities(plant)[2, 2] > 0.1  # a rear foot goes up


def update_velocities(plant: Plant) -> None:
    """Update MuJoCo's velocities from qpos and qvel."""
    mujoco.mj_forward(plant.model, plant.data)


def test_leg_collisions_keep_pairs_that_the_srdf_disables_and_exclude_overlapping_ones() -> None:
    for name, overlapping in (("a1", 0), ("go1", 0), ("go2", 2), ("b1", 4)):
        plant = Plant(name, PlantSettings(leg_collisions=True))
        assert plant.model.nexclude == overlapping
        assert plant.leg_contacts == frozenset()
    hips = [plant.model.joint(f"{leg}_hip_joint").qposadr[0] for leg in ("FR", "FL")]
    plant.data.qpos[2] += 1.0
    plant.data.qpos[hips] = [1.5, -1.5]  # both front legs inwards
    update_velocities(plant)
    assert ("FR", "FL") in plant.leg_contacts


def test_walk_controller_at_velocity_zero_sends_the_bytes_of_a_stand_controller() -> None:
    plant = Plant("go1", PlantSettings(seed=3))
    plant.add_push(Push("lateral", 0.5 * plant.lip_push_limit("lateral"), 0.1, 0.3))
    stand = surefoot.StandController(plant.robot)
    walk = surefoot.WalkController(plant.robot)
    state = plant.reset()
    for _ in range(1000):
        walk.set_velocity(surefoot.WalkVelocity())
        command = stand.update(state)
        assert walk.update(state).to_bytes() == command.to_bytes()
        state = plant.step(command)
    assert not walk.walking


def test_payload_off_centre_does_not_tilt_a_robot_that_turns() -> None:
    settings = WalkSettings(duration=5.0, velocities=(parse_velocity("0.3,0,1@0.6"),))
    plant = replace(
        settings.plant,
        physics_dt=0.001,
        foot_force="est",
        payload_kg=0.3 * surefoot.load_robot("go1").mass,
        payload_position=(0.0, 0.05, 0.05),
    )
    summary = summarise(run_walk(replace(settings, plant=plant)))
    assert not summary["fell"]
    assert summary["roll_pitch_rms_deg"][0] < 1.0
