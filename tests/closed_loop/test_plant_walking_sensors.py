# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import math

import mujoco
import numpy as np
import pytest
from plant_helpers import float_without_gravity, pd_command
from surefoot.messages.low_state_layout import LOW_STATE
from surefoot.robot.loading import load_robot
from surefoot.sim import Plant, PlantSettings, Push
from surefoot.sim.hardware.walking_errors import draw_vibration


def drop(settings: PlantSettings, height: float, ticks: int) -> tuple[Plant, np.ndarray]:
    """Drop a Go1 that holds its standing pose; return its plant and its samples."""
    plant = Plant("go1", settings)
    plant.data.qpos[2] += height
    mujoco.mj_step1(plant.model, plant.data)  # Plant.step() begins with mj_step2
    cmd = pd_command(plant)
    samples = np.zeros(ticks, LOW_STATE)
    for k in range(ticks):
        samples[k] = plant.step(cmd).raw.view(LOW_STATE)[0]
    return plant, samples


def test_walking_sensors_have_no_effect_on_ideal_sensors() -> None:
    samples = [
        drop(PlantSettings(sensors="ideal", foot_force="est", walking_sensors=walking), 0.02, 100)[
            1
        ]
        for walking in (False, True)
    ]
    np.testing.assert_array_equal(samples[0], samples[1])


def test_walking_errors_leave_physics_and_other_sensors_unchanged() -> None:
    plain, walking = (
        drop(PlantSettings(foot_force="raw", walking_sensors=walking), 0.02, 100)[1]
        for walking in (False, True)
    )
    np.testing.assert_array_equal(plain["motorState"], walking["motorState"])
    assert (plain["gyroscope"] != walking["gyroscope"]).any()


@pytest.mark.parametrize("soft_soles", [False, True])
def test_gyroscope_vibrates_after_a_touchdown_and_is_quiet_at_rest(soft_soles: bool) -> None:
    plain, walking = (
        drop(PlantSettings(walking_sensors=walking, soft_soles=soft_soles), 0.03, 500)[1]
        for walking in (False, True)
    )
    vibration = walking["gyroscope"] - plain["gyroscope"]  # the noise is the same
    assert np.abs(vibration[:100]).max() > 0.2
    assert np.abs(vibration[-100:]).max() < 0.002
    assert walking["gyroscope"][-100:].std() < 0.01
    tilt = walking["rpy"][:, :2] - plain["rpy"][:, :2]  # the attitude filter integrates it
    assert 0.0 < np.degrees(np.abs(tilt).max()) < 1.2


@pytest.mark.parametrize("dt", [0.0005, 0.001])
def test_vibration_has_no_net_rotation_and_no_net_velocity(dt: float) -> None:
    settings = PlantSettings(physics_dt=dt, soft_soles=True)
    vibration = draw_vibration(load_robot("go1"), settings, np.random.default_rng(1))
    values = []
    for k in range(400):
        # A foot's load rises within 5 ms.
        vibration.step(np.array([min(1.0, k * dt / 0.005) * 60.0, 0.0, 0.0, 0.0]))
        values.append(vibration.value)
    swing = np.abs(values).sum(axis=0)
    assert np.abs(values).max(axis=0)[:3].min() > 0.05
    assert (np.abs(np.sum(values, axis=0)) < 0.01 * swing).all()


def test_gyroscope_and_accelerometer_clip_at_their_ranges() -> None:
    plant = Plant("go1", PlantSettings(walking_sensors=True), [Push("lateral", 100.0, 0.01)])
    float_without_gravity(plant)
    plant.data.qvel[3] = 60.0  # [rad/s]
    mujoco.mj_step1(plant.model, plant.data)
    samples = [plant.step(pd_command(plant)).imu for _ in range(4)]
    gyro = np.max([np.abs(imu.gyroscope) for imu in samples])
    accelerometer = np.max([np.abs(imu.accelerometer) for imu in samples])
    assert gyro == pytest.approx(math.radians(2000.0))
    assert accelerometer == pytest.approx(8.0 * 9.81)


@pytest.mark.parametrize(("control_rate", "readings"), [(250.0, 1), (500.0, 2), (1000.0, 4)])
def test_accelerometer_has_a_rate_of_its_own(control_rate: float, readings: int) -> None:
    imu = drop(PlantSettings(walking_sensors=True, control_rate=control_rate), 0.0, 60)[1]
    changes = np.flatnonzero((imu["accelerometer"][1:] != imu["accelerometer"][:-1]).any(axis=1))
    assert (np.diff(changes) == readings).all() and len(changes) >= 60 // readings - 1
    assert not (imu["gyroscope"][1:] == imu["gyroscope"][:-1]).all(axis=1).any()


def counts_and_forces(plant: Plant, ticks: int) -> tuple[np.ndarray, np.ndarray]:
    """Return footForce [counts] and the true normal forces [N], read without delay."""
    counts, forces = [], []
    for _ in range(ticks):
        plant.advance()
        counts.append(plant.read().footForce.astype(float))
        forces.append(plant.truth.foot_forces[2])
    return np.array(counts), np.array(forces)


def test_counts_fall_to_a_twentieth_in_24_ms_after_lift_off() -> None:
    plant = Plant("go1", PlantSettings(foot_force="raw", walking_sensors=True))
    loaded = counts_and_forces(plant, 25)[0].mean(axis=0)
    float_without_gravity(plant)
    falling = counts_and_forces(plant, 100)[0]
    unloaded = falling[50:].mean(axis=0)
    share = ((falling - unloaded) / (loaded - unloaded)).mean(axis=1)
    assert 0.020 <= 0.002 * np.argmax(share < 0.05) <= 0.028


def test_counts_rise_with_the_force_at_touchdown() -> None:
    plant = drop(PlantSettings(foot_force="raw", walking_sensors=True), 0.02, 0)[0]
    counts, forces = counts_and_forces(plant, 60)
    unloaded = counts[:20].mean(axis=0)
    assert forces[:20].max() == 0.0
    for leg in range(4):
        touchdown = int(np.argmax(forces[:, leg] > 5.0))
        assert touchdown > 20
        gain = (counts[touchdown, leg] - unloaded[leg]) / forces[touchdown, leg]
        assert 5.0 < gain  # counts/N; larger if the force has already fallen again


def test_foot_moves_above_20_cm_per_s_for_20_to_35_ms_after_its_soft_sole_touched_down() -> None:
    def moving_time(soft_soles: bool) -> float:
        settings = PlantSettings(sensors="ideal", soft_soles=soft_soles, control_rate=1000.0)
        plant = drop(settings, 0.02, 0)[0]
        heights, forces, cmd = [], [], pd_command(plant)
        for _ in range(150):
            plant.step(cmd)
            heights.append(plant.truth.p_world_feet[2, 0])
            forces.append(plant.truth.foot_forces[2, 0])
        touchdown = int(np.argmax(np.array(forces) > 0.0))
        speed = -np.diff(heights)[touchdown:] / 0.001
        return 0.001 * float(np.argmax(speed < 0.2))

    assert moving_time(soft_soles=False) <= 0.005
    assert 0.020 <= moving_time(soft_soles=True) <= 0.035


def test_robot_stands_5_mm_deep_in_its_soft_soles() -> None:
    plant = drop(PlantSettings(soft_soles=True), 0.0, 500)[0]
    depth = plant.robot.config.foot_radius - plant.truth.p_world_feet[2]
    assert depth.mean() == pytest.approx(0.005, rel=0.02)
    assert np.abs(plant.truth.v[:6]).max() < 1e-3
