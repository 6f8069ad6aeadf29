# SPDX-License-Identifier: BSD-3-Clause
"""Drops of a robot until it lies at rest."""

from __future__ import annotations

import numpy as np
import pytest
import surefoot
from surefoot.sim import Plant, PlantSettings, Push
from surefoot.sim import plant as plant_module
from surefoot.sim.physics.lying_pose import MAX_REST_TILT, legs_clear, may_settle

pytestmark = pytest.mark.slow

FAST = PlantSettings(physics_dt=0.001)


@pytest.mark.parametrize("robot", ["go1", "b1"])
def test_dropped_robot_lies_still_level_and_repeatable(robot: str) -> None:
    poses = []
    for _ in range(2):
        plant = Plant(robot, FAST)
        plant.reset_lying(np.random.default_rng(4))
        poses.append(plant.data.qpos.copy())
        assert plant.data.xmat[plant.handles.root, 8] > np.cos(MAX_REST_TILT)
        assert legs_clear(plant.model, plant.data, plant.handles)
        assert np.abs(plant.data.qvel).max() < 0.5
        assert plant.data.qpos[2] < 0.7 * Plant(robot, FAST).data.qpos[2]
    assert np.array_equal(*poses)


def test_drop_with_45_deg_tilt_is_abandoned() -> None:
    plant = Plant("go1", FAST)
    plant.reset()
    assert may_settle(plant.model, plant.data, plant.handles)
    plant.data.xmat[plant.handles.root, 8] = np.cos(np.radians(45.0))
    assert not may_settle(plant.model, plant.data, plant.handles)


def test_drop_that_never_rests_raises_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(plant_module, "MAX_DROPS", 2)
    monkeypatch.setattr(plant_module, "is_settled", lambda *_: False)
    with pytest.raises(surefoot.Error, match="'go1': dropped 2 times, it never came to rest"):
        Plant("go1", FAST).reset_lying(np.random.default_rng(4))


@pytest.mark.parametrize("dropped", [True, False])
def test_push_acts_once_on_a_lying_robot(dropped: bool) -> None:
    plant = Plant("go1", FAST, [Push("forward", 2.0, time=0.1)])
    if dropped:
        plant.reset_lying(np.random.default_rng(1))
    else:
        plant.reset_lying_at(plant.data.qpos.copy())
    given = 0.0
    for _ in range(150):
        plant.step(surefoot.damping_low_cmd(3.0))
        given += 0.002 * float(np.linalg.norm(plant.push_force[0]))
    assert given == pytest.approx(2.0, rel=0.03)
