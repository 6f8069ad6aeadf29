# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import surefoot
from plant_helpers import ROBOTS, pd_command
from surefoot.sim import Flaws, Plant, PlantSettings


def test_given_imu_biases_are_applied() -> None:
    flaws = Flaws(gyro_bias=(0.02, -0.02, 0.01), accelerometer_bias=(0.2, 0.0, -0.2))
    plant = Plant("go1", PlantSettings(flaws=flaws, hung=True))
    assert plant.imu_bias == pytest.approx([0.02, -0.02, 0.01, 0.2, 0.0, -0.2])
    readings = [plant.step(pd_command(plant)) for _ in range(500)]
    gyro = np.mean([state.imu.gyroscope for state in readings], axis=0)
    assert gyro == pytest.approx([0.02, -0.02, 0.01], abs=2e-3)


def test_random_imu_biases_are_normally_distributed() -> None:
    usual = Plant("go1", PlantSettings(seed=3))
    flaws = Flaws(gyro_bias=0.01, accelerometer_bias=0.1)
    drawn = Plant("go1", PlantSettings(seed=3, flaws=flaws))
    assert np.all(drawn.imu_bias != usual.imu_bias)
    rng = np.random.default_rng(0)
    from surefoot.sim.flaws import draw_bias

    draws = np.array([draw_bias(0.1, 1.0, rng) for _ in range(2000)])
    assert draws.std() == pytest.approx(0.1, rel=0.05)
    assert np.abs(draws).max() > 0.25


@pytest.mark.parametrize("robot", ROBOTS)
def test_scaled_trunk_changes_the_mass_and_the_centre_of_mass(robot: str) -> None:
    usual = Plant(robot, PlantSettings(sensors="ideal"))
    flaws = Flaws(trunk_mass_scale=1.5, trunk_com_shift=(0.03, 0.0, 0.0))
    heavy = Plant(robot, PlantSettings(sensors="ideal", flaws=flaws))
    root = usual.handles.root
    mass = [float(p.model.body_subtreemass[root]) for p in (usual, heavy)]
    assert mass[0] == pytest.approx(usual.robot.mass, rel=1e-3)
    trunk = 2.0 * (mass[1] - mass[0])
    assert 0.3 * mass[0] < trunk < 0.8 * mass[0]
    assert heavy.truth.com[0] > usual.truth.com[0] + 0.5 * 0.03 * 1.5 * trunk / mass[1]


def test_torque_error_setting_scales_the_motor_torque_error() -> None:
    plant = Plant("go1", PlantSettings(flaws=Flaws(torque_error=0.2)))
    ratio = plant.motors.torque / plant.motors.estimated_torque
    assert 0.08 < np.abs(ratio - 1.0).max() <= 0.2 + 1e-9


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("gyro_bias", -0.1),
        ("gyro_bias", (0.0, 0.0)),
        ("accelerometer_bias", float("nan")),
        ("torque_error", 1.0),
        ("trunk_mass_scale", 0.0),
        ("trunk_com_shift", (0.0, 0.0, 2.0)),
    ],
)
def test_invalid_flaw_error_names_the_field(field: str, value: Any) -> None:
    with pytest.raises(surefoot.Error, match=rf"^{field}: got "):
        Flaws(**{field: value})
