# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import numpy as np
import pytest
from plant_helpers import ROBOTS, float_without_gravity, pd_command
from surefoot.geometry.rotations import matrix_from_wxyz
from surefoot.sim import Plant, PlantSettings, Push
from surefoot.sim.hardware.encoders import RealEncoders
from surefoot.sim.hardware.foot_sensors import FootSensors


@pytest.mark.parametrize("name", ROBOTS)
def test_the_accelerometer_reads_plus_g_on_z_at_rest(name: str) -> None:
    state = Plant(name, PlantSettings(sensors="ideal")).reset()
    np.testing.assert_allclose(state.imu.accelerometer, [0.0, 0.0, 9.81], atol=0.05)


def test_gyroscope_equals_the_quaternion_rate_in_imu_axes() -> None:
    plant = Plant("go1", PlantSettings(sensors="ideal"), [Push(60.0, 6.0, 0.1, 0.0, height=0.05)])
    cmd, last, turned, rate = pd_command(plant), plant.reset(), [], []
    for _ in range(60):
        state = plant.step(cmd)
        before, after = (matrix_from_wxyz(s.imu.quaternion) for s in (last, state))
        step = before.T @ after
        turned.append(
            0.5
            * np.array([step[2, 1] - step[1, 2], step[0, 2] - step[2, 0], step[1, 0] - step[0, 1]])
            / 0.002
        )
        rate.append(0.5 * (last.imu.gyroscope + state.imu.gyroscope))
        last = state
    assert np.abs(rate).max(axis=0).min() > 0.1  # all three axes have moved
    np.testing.assert_allclose(turned, rate, atol=0.02)


def test_accelerometer_measures_at_its_mount_position() -> None:
    # The body rotates, so an IMU beside the base's origin measures the lever-arm acceleration.
    plant = Plant("go1", PlantSettings(sensors="ideal", control_rate=2000.0))
    float_without_gravity(plant)
    cmd = pd_command(plant, kp=15.0, kd=0.4)
    plant.add_push(Push("lateral", 20.0, 0.1, 0.0, height=0.05))
    felt, lever = np.zeros(3), plant.robot.config.p_base_imu
    for _ in range(200):
        state = plant.step(cmd)
        felt += matrix_from_wxyz(state.imu.quaternion) @ state.imu.accelerometer * 0.0005
    v = plant.truth.v
    mount = plant.data.xmat[plant.handles.root].reshape(3, 3) @ (v[:3] + np.cross(v[3:6], lever))
    base = plant.data.xmat[plant.handles.root].reshape(3, 3) @ v[:3]
    np.testing.assert_allclose(felt, mount, atol=0.02)
    assert np.linalg.norm(felt - base) > 0.1


def test_sensor_noise_and_bias_match_the_stated_values() -> None:
    plant = Plant("go1", PlantSettings(seed=3))
    cmd = pd_command(plant)
    states = [plant.step(cmd) for _ in range(1000)]
    for name, sigma, rest in (("gyroscope", 0.005, 0.0), ("accelerometer", 0.05, 9.81)):
        values = np.array([getattr(state.imu, name) for state in states[500:]])
        np.testing.assert_allclose(values.std(axis=0), sigma, rtol=0.15)
        up = np.array([0.0, 0.0, rest])
        bias = values.mean(axis=0) - plant.data.xmat[plant.handles.root].reshape(3, 3).T @ up
        assert 0.0 < np.abs(bias).max() < 1.2 * sigma
    speed = np.array([[state.motorState[i].dq for i in range(12)] for state in states[500:]])
    np.testing.assert_allclose(speed.std(), 0.05, rtol=0.05)


def test_attitude_filter_keeps_tilt_and_drifts_in_yaw() -> None:
    plant = Plant("go1", PlantSettings(seed=1))
    cmd = pd_command(plant)
    gyro_bias_z = np.mean([plant.step(cmd).imu.gyroscope[2] for _ in range(2500)])
    state = plant.step(cmd)
    truth = plant.data.xmat[plant.handles.root].reshape(3, 3)
    believed = matrix_from_wxyz(state.imu.quaternion)
    tilt_error = np.arccos(np.clip(believed[2] @ truth[2], -1.0, 1.0))
    assert np.degrees(tilt_error) < 1.2
    assert state.imu.rpy[2] == pytest.approx(gyro_bias_z * 5.0, abs=0.005)
    assert abs(state.imu.rpy[2]) > 0.005


def test_the_attitude_filter_follows_a_fast_turn() -> None:
    plant = Plant("go2", PlantSettings(), [Push("lateral", 14.0, 0.1, 0.0)])
    cmd, worst, tilt = pd_command(plant), 0.0, 0.0
    for _ in range(200):
        true_up = plant.data.xmat[plant.handles.root].reshape(3, 3)[2].copy()
        believed_up = matrix_from_wxyz(plant.step(cmd).imu.quaternion)[2]
        worst = max(worst, float(np.linalg.norm(true_up - believed_up)))
        tilt = max(tilt, float(np.hypot(*true_up[:2])))
    assert tilt > 0.1
    assert worst < 0.04


@pytest.mark.parametrize(("name", "unit"), [("go1", 256), ("b1", 128)])
def test_tau_est_is_quantised_like_the_wire_format(name: str, unit: int) -> None:
    state = Plant(name).reset()
    torque = np.array([state.motorState[i].tauEst for i in range(12)])
    assert np.abs(torque).max() > 1.0
    np.testing.assert_array_equal(torque * unit, np.round(torque * unit))


def test_tau_est_excludes_the_motor_torque_error() -> None:
    plant = Plant("go1")
    cmd = pd_command(plant)
    for _ in range(200):
        state = plant.step(cmd)
    believed = np.array([state.motorState[i].tauEst for i in (2, 5, 8, 11)])
    scale = plant.truth.tau[2::3] / believed
    assert 0.003 < np.abs(scale - 1.0).max() < 0.055


def test_encoder_error_is_below_one_quantum() -> None:
    plant = Plant("go1")
    state = plant.reset()
    q = np.array([state.motorState[i].q for i in range(12)])
    error = q - plant.data.qpos[plant.handles.motor_q]
    assert 0.0 < np.abs(error).max() < 1e-4


def test_ideal_foot_forces_are_in_newtons() -> None:
    plant = Plant("go1", PlantSettings(sensors="ideal", foot_force="est"))
    state = plant.step(pd_command(plant))
    expected = np.round(plant.truth.foot_forces[2])
    np.testing.assert_array_equal(state.footForceEst, expected)
    np.testing.assert_array_equal(state.footForce, expected)


def test_foot_force_setting_selects_the_live_fields() -> None:
    def forces(kind: str | None) -> tuple[np.ndarray, np.ndarray]:
        state = Plant("go1", PlantSettings(foot_force=kind)).reset()
        return np.array(state.footForce), np.array(state.footForceEst)

    raw, newtons = forces("est")
    assert raw.min() > 20
    assert np.abs(newtons - 13.1 * 9.81 / 4).max() < 15
    raw, newtons = forces("raw")
    assert raw.min() > 20
    assert not newtons.any()
    for kind in ("dead", None):  # a real go1's footForceEst is zero
        raw, newtons = forces(kind)
        assert not raw.any()
        assert not newtons.any()


def test_raw_foot_counts_have_individual_offsets_without_load() -> None:
    plant = Plant("go1", PlantSettings(foot_force="raw"))
    float_without_gravity(plant)
    for _ in range(3):
        state = plant.step(pd_command(plant))
    assert 0 <= state.footForce.min() <= state.footForce.max() <= 58
    assert len(set(state.footForce.tolist())) > 1


def test_raw_foot_counts_drift_3_to_10_per_minute() -> None:
    drifts = []
    for seed in range(8):
        sensors = FootSensors("raw", 1.0, np.random.default_rng(seed))
        readings = [sensors.read(np.zeros(4))[0].astype(float) for _ in range(120)]
        drifts.append(np.mean(readings[90:], axis=0) - np.mean(readings[:30], axis=0))
    assert 3.0 < np.std(drifts) < 10.0


def test_velocity_filter_is_first_order_at_100_hz() -> None:
    encoders = RealEncoders(0.0001, np.random.default_rng(0))
    for _ in range(16):  # one time constant, 1.6 ms
        encoders.step(np.full(12, 10.0))
    _, velocity = encoders.read(np.zeros(12), np.full(12, 10.0))
    expected = 10.0 * (1.0 - np.exp(-2.0 * np.pi * 100.0 * 0.0016))
    assert velocity.mean() == pytest.approx(expected, abs=0.05)
