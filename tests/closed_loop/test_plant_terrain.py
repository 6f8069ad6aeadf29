# SPDX-License-Identifier: BSD-3-Clause
"""Terrain of the plant: geometry, contacts, bad values."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import surefoot
from surefoot.sim import Plant, PlantSettings, Terrain
from surefoot.sim.terrain import FIRST_EDGE


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"step_height": -0.1}, "terrain: step_height: got -0.1, expected a number from 0 to 0.5"),
        ({"step_height": float("nan")}, "terrain: step_height: got nan"),
        ({"step_height": "high"}, "terrain: step_height: got 'high'"),
        ({"step_height": 0.1, "step_heading_deg": 80.0}, "terrain: step_heading_deg: got 80"),
        ({"step_heading_deg": 30.0}, "got step_heading_deg 30 without step_height"),
        ({"stairs_height": 0.05, "stairs_tread": 0.0}, "terrain: stairs_tread: got 0"),
        ({"block_height": float("inf")}, "terrain: block_height: got inf"),
        (
            {"step_height": 0.1, "stairs_height": 0.05},
            "terrain: got step_height and stairs_height, expected one of them",
        ),
        ({"block_height": 0.1, "seed": -1}, "terrain: seed: got -1, expected a whole number"),
    ],
)
def test_wrong_terrain_is_refused_by_name(values: dict[str, Any], message: str) -> None:
    with pytest.raises(surefoot.Error, match=message):
        Terrain(**values)


@pytest.mark.parametrize(
    "others",
    [{"slope_deg": 5.0}, {"hung": True}, {"block_foot": "FR"}, {"platform_heading_deg": 0.0}],
)
def test_terrain_needs_fixed_level_ground(others: dict[str, Any]) -> None:
    with pytest.raises(surefoot.Error, match="terrain: got it together with a slope"):
        PlantSettings(terrain=Terrain(step_height=0.1), **others)
    with pytest.raises(surefoot.Error, match=r"terrain: got 0\.1, expected a Terrain"):
        PlantSettings(terrain=0.1)


def test_platform_begins_at_a_distance_drawn_from_its_seed() -> None:
    edges = []
    for seed in range(8):
        terrain = Terrain(step_height=0.08, step_heading_deg=30.0, seed=seed)
        x = np.arange(0.0, 4.0, 0.001)
        heights = terrain.heights_at(np.stack([x, 0.0 * x], axis=1))
        assert set(heights) == {0.0, 0.08}
        edges.append(float(x[heights > 0.0][0]))
        assert terrain.end == pytest.approx(x[heights > 0.0][-1], abs=2e-3)
    assert min(edges) >= FIRST_EDGE and np.ptp(edges) > 0.1


def test_stairs_go_up_and_down_by_equal_steps() -> None:
    terrain = Terrain(stairs_height=0.05, stairs_tread=0.3)
    x = np.arange(0.0, terrain.end + 0.1, 0.001)
    heights = terrain.heights_at(np.stack([x, 0.0 * x], axis=1))
    steps = np.diff(heights)
    np.testing.assert_allclose(steps[steps != 0.0], [0.05] * 5 + [-0.05] * 5)
    np.testing.assert_allclose(np.diff(x[1:][steps > 0.0]), 0.3, atol=2e-3)


def test_blocks_have_all_heights_up_to_the_given_one() -> None:
    heights = [box.height for box in Terrain(block_height=0.03).boxes()]
    assert 0.0 <= min(heights) < 0.003 and 0.027 < max(heights) <= 0.03
    assert heights != [box.height for box in Terrain(block_height=0.03, seed=1).boxes()]


@pytest.mark.parametrize("soft", [False, True])
def test_robot_stands_on_a_platform_with_forces_of_its_weight(soft: bool) -> None:
    terrain = Terrain(step_height=0.08)
    plant = Plant("go1", PlantSettings(sensors="ideal", terrain=terrain, soft_soles=soft))
    controller = surefoot.StandController(plant.robot)
    state = plant.reset()
    plant.data.qpos[:3] += [FIRST_EDGE + 0.9, 0.0, 0.08]
    for _ in range(250):
        state = plant.step(controller.update(state))
    truth = plant.truth
    assert not truth.fell and truth.contact.all()
    weight = 9.81 * plant.robot.mass
    assert truth.foot_forces[2].sum() == pytest.approx(weight, rel=0.02)
    heights = truth.p_world_feet[2] - plant.robot.config.foot_radius
    np.testing.assert_allclose(heights, 0.08, atol=0.01 if soft else 1e-3)


def test_trunk_on_a_platform_is_a_fall() -> None:
    plant = Plant("go1", PlantSettings(sensors="ideal", terrain=Terrain(step_height=0.08)))
    state = plant.reset()
    plant.data.qpos[:3] += [FIRST_EDGE + 0.9, 0.0, 0.3]
    for _ in range(500):  # the motors are off
        plant.step(surefoot.LowCmd())
        if plant.truth.fell:
            break
    assert plant.truth.fell
    assert state is not None
