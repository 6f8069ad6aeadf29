# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import numpy as np
import pytest
from plant_helpers import pd_command
from surefoot.sim import Plant, PlantSettings


def ticks_until_a_command_acts(settings: PlantSettings) -> int:
    """Count control periods from sending a zero-gain command until the torque is zero."""
    plant = Plant("go1", settings)
    cmd, no_torque = pd_command(plant, kp=15.0, kd=0.4), pd_command(plant, kp=0.0, kd=0.0)
    for _ in range(50):
        plant.step(cmd)
    for tick in range(1, 20):
        plant.step(no_torque)
        if np.abs(plant.truth.tau).max() < 1e-9:
            return tick
    raise AssertionError("the command never acted")


@pytest.mark.parametrize(
    ("sensors", "extra_delay", "expected"),
    [("ideal", 0.0, 1), ("real", 0.0, 2), ("real", 0.004, 4), ("ideal", 0.002, 2)],
)
def test_command_delay_matches_the_settings(
    sensors: str, extra_delay: float, expected: int
) -> None:
    settings = PlantSettings(sensors=sensors, motor_lag=0.0, extra_delay=extra_delay)
    assert ticks_until_a_command_acts(settings) == expected


@pytest.mark.parametrize(("sensors", "periods"), [("ideal", 0), ("real", 1)])
def test_state_age_is_exact_in_periods(sensors: str, periods: int) -> None:
    plant = Plant("go1", PlantSettings(sensors=sensors))
    no_torque, angles, readings = pd_command(plant, kp=0.0, kd=0.0), [], []
    for _ in range(30):
        readings.append(plant.step(no_torque).motorState[2].q)
        angles.append(plant.data.qpos[plant.handles.motor_q][2])
    fresh = np.array(angles[10 - periods : 30 - periods])
    assert np.abs(np.diff(fresh)).min() > 2e-4  # the calf moves: one period is visible
    np.testing.assert_allclose(readings[10:], fresh, atol=5e-5)


def test_extra_delay_counts_physics_steps() -> None:
    plant = Plant("go1", PlantSettings(sensors="ideal", motor_lag=0.0, extra_delay=0.001))
    for _ in range(5):
        plant.step(pd_command(plant, kp=15.0, kd=0.4))
    plant.step(pd_command(plant, kp=0.0, kd=0.0))  # acts half-way through this period
    assert np.abs(plant.truth.tau).max() < 1e-9
    assert plant.time == pytest.approx(6 * 0.002)
