# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import numpy as np
import pytest
from surefoot.geometry.rotations import matrix_from_wxyz, wxyz_from_rotation_vector
from surefoot.robot.loading import describe_robot
from surefoot.sim import Plant, PlantSettings
from surefoot.sim.hardware.attitude_filter import MAHONY_GAIN, MahonyFilter

STILL = (0.0, 0.0, 0.0)


def test_filter_starts_aligned_with_the_accelerometer() -> None:
    true_up = np.array([0.3, -0.2, 0.9]) / np.linalg.norm([0.3, -0.2, 0.9])
    attitude = matrix_from_wxyz(MahonyFilter(*(9.81 * true_up)).quaternion)
    np.testing.assert_allclose(attitude[2], true_up, atol=1e-12)
    assert attitude[1, 0] == pytest.approx(0.0, abs=1e-12)  # yaw 0


@pytest.mark.parametrize("axis", [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 2, -1]])
def test_the_filter_integrates_the_gyro_in_body_axes(axis: list[float]) -> None:
    turn = np.array(axis) / np.linalg.norm(axis)
    filter_ = MahonyFilter(2.0, -1.0, 9.0)
    start = matrix_from_wxyz(filter_.quaternion)
    for _ in range(1000):
        filter_.update(tuple(turn), (0.0, 0.0, 0.0), 0.001)
    expected = start @ matrix_from_wxyz(wxyz_from_rotation_vector(turn))
    np.testing.assert_allclose(matrix_from_wxyz(filter_.quaternion), expected, atol=1e-5)


@pytest.mark.parametrize("tilt", [[0.1, 0.0], [0.0, 0.1], [-0.08, 0.06]])
def test_a_tilt_error_decays_with_the_filters_gain(tilt: list[float]) -> None:
    wrong = matrix_from_wxyz(wxyz_from_rotation_vector([*tilt, 0.0]))
    filter_ = MahonyFilter(*wrong[2])
    for _ in range(2000):
        filter_.update(STILL, (0.0, 0.0, 9.81), 0.001)
    error = np.linalg.norm(matrix_from_wxyz(filter_.quaternion)[2, :2])
    assert error == pytest.approx(0.1 * np.exp(-MAHONY_GAIN * 2.0), rel=0.01)


def test_a_gyro_bias_tilts_the_estimate_by_bias_over_gain() -> None:
    filter_ = MahonyFilter(0.0, 0.0, 9.81)
    for _ in range(20_000):
        filter_.update((0.005, 0.0, 0.0), (0.0, 0.0, 9.81), 0.001)
    believed_up = matrix_from_wxyz(filter_.quaternion)[2]
    assert np.hypot(*believed_up[:2]) == pytest.approx(0.005 / MAHONY_GAIN, rel=0.01)


def test_first_state_has_the_slope_attitude() -> None:
    state = Plant("go1", PlantSettings(slope_deg=10.0)).reset()
    assert np.degrees(state.imu.rpy[1]) == pytest.approx(-10.0, abs=1.0)


def test_rotated_imu_reads_in_its_own_axes() -> None:
    description = describe_robot("go1")
    half_turn_about_x = [0.0, 1.0, 0.0, 0.0]
    description.table["imu"] = {"position": [0.0, 0.0, 0.05], "quaternion": half_turn_about_x}
    state = Plant(description, PlantSettings(sensors="ideal")).reset()
    np.testing.assert_allclose(state.imu.accelerometer, [0.0, 0.0, -9.81], atol=0.05)
    np.testing.assert_allclose(np.abs(state.imu.quaternion), np.abs(half_turn_about_x), atol=0.01)
