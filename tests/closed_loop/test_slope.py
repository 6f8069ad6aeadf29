# SPDX-License-Identifier: BSD-3-Clause
"""Robots that start on a slope: no sudden motion, and feet and body stay in place."""

from __future__ import annotations

import numpy as np
import pytest
import surefoot
from surefoot.assess.push_outcome import attitude_angles
from surefoot.sim import Plant, PlantSettings


@pytest.mark.parametrize("heading", [0.0, 90.0, 180.0])
@pytest.mark.parametrize("robot", ["a1", "go1", "go2", "b1"])
def test_robot_stands_on_a_15_deg_slope_from_the_first_tick(robot: str, heading: float) -> None:
    settings = PlantSettings(seed=1, friction=0.6, slope_deg=15.0, slope_heading_deg=heading)
    plant = Plant(robot, settings)
    controller = surefoot.StandController(plant.robot)
    state = plant.reset()
    feet = plant.data.xpos[plant.handles.foot_bodies].copy()
    attitude = plant.data.qpos[3:7].copy()
    for k in range(1500):
        state = plant.step(controller.update(state))
        # While the ground normal converges, contact points move on the soles; the robot does not.
        if k < 50:
            assert np.linalg.norm(controller.state.v[:3]) < 0.1
    moved = plant.data.xpos[plant.handles.foot_bodies] - feet
    assert np.linalg.norm(moved, axis=1).max() < 0.01
    assert np.degrees(attitude_angles(plant.data.qpos[None, 3:7], attitude)[0]) < 2.0
