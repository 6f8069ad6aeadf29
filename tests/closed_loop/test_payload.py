# SPDX-License-Identifier: BSD-3-Clause
"""An unknown payload causes no pose error, and its mass and position are estimated."""

from __future__ import annotations

import numpy as np
import pytest
from surefoot import StandController
from surefoot.geometry.rotations import matrix_from_wxyz
from surefoot.sim import Plant, PlantSettings

KILOGRAMS = 4.0
POSITION = (0.08, -0.03, 0.1)  # [m] from the trunk's origin


def stand_with_payload(zero_tau_est: bool) -> tuple[Plant, StandController, float, float]:
    """Stand for 4 s; return plant, controller, and final errors of height [m] and tilt [rad]."""
    plant = Plant("go1", PlantSettings(payload_kg=KILOGRAMS, payload_position=POSITION))
    controller = StandController(plant.robot)
    state = plant.reset()
    height, up = plant.data.qpos[2], matrix_from_wxyz(plant.data.qpos[3:7])[2].copy()
    for _ in range(2000):
        if zero_tau_est:
            for motor in state.motorState:
                motor.tauEst = 0.0
        state = plant.step(controller.update(state))
    assert not plant.truth.fell
    tilt_angle = np.arccos(np.clip(up @ matrix_from_wxyz(plant.data.qpos[3:7])[2], -1.0, 1.0))
    return plant, controller, abs(plant.data.qpos[2] - height), float(tilt_angle)


@pytest.mark.parametrize("zero_tau_est", [False, True], ids=["by tauEst", "by commanded torques"])
def test_payload_causes_no_height_or_tilt_error(zero_tau_est: bool) -> None:
    _, _, height, tilt = stand_with_payload(zero_tau_est)
    assert height < 1e-3
    assert np.degrees(tilt) < 0.1


def test_payload_mass_and_com_shift_are_estimated() -> None:
    plant, controller, _, _ = stand_with_payload(zero_tau_est=False)
    report = controller.estimator_report
    assert report.payload == pytest.approx(KILOGRAMS, rel=0.1)
    total = plant.robot.mass + KILOGRAMS
    com = report.com_shift
    # The model's centre of mass is near the trunk's origin, from which POSITION is measured.
    assert com[0] == pytest.approx(KILOGRAMS * POSITION[0] / total, abs=0.006)
    assert com[1] == pytest.approx(KILOGRAMS * POSITION[1] / total, abs=0.006)
