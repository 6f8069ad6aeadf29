# SPDX-License-Identifier: BSD-3-Clause
"""Walks over a platform, stairs and blocks that the controller does not see; one robot each."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from surefoot.sim import Terrain
from surefoot.walk import WalkLog, WalkSettings, parse_velocity, run_walk
from surefoot.walk.steps import stance_phases

pytestmark = pytest.mark.slow


SOLE_SINK = 0.015  # [m] a sole sinks by 10 mm under half of the robot, more while it lands


def walk(robot: str, duration: float, **plant: object) -> WalkLog:
    """Walk ahead at 0.4 m/s on a plant with these settings."""
    settings = WalkSettings(
        robot=robot, duration=duration, velocities=(parse_velocity("0.4,0,0@0.4"),)
    )
    return run_walk(replace(settings, plant=replace(settings.plant, **plant)))


def highest_stance(log: WalkLog) -> np.ndarray:
    """Return the largest height (4,) at which each foot stood [m]."""
    heights = np.zeros(4)
    for phase in stance_phases(log):
        middle = (phase.start + phase.end) // 2
        height = log.feet[middle, 2, phase.leg] - log.robot.config.foot_radius
        heights[phase.leg] = max(heights[phase.leg], height)
    return heights


@pytest.mark.parametrize(
    ("robot", "terrain", "top"),
    [
        ("go1", Terrain(step_height=0.08, seed=1), 0.08),
        ("a1", Terrain(block_height=0.03, seed=1), 0.02),
    ],
)
def test_robot_crosses_a_terrain_that_it_does_not_see(
    robot: str, terrain: Terrain, top: float
) -> None:
    log = walk(robot, terrain.end / 0.4 + 2.5, terrain=terrain)
    assert not log.fell
    assert (highest_stance(log) > top - SOLE_SINK).all()  # each foot stood on it
    assert log.feet[-1, 0].min() > terrain.end  # and has left it
    assert log.leg_contacts.sum() == 0


def test_robot_begins_to_walk_on_a_slope_that_unloads_a_foot() -> None:
    log = walk("go1", 3.0, slope_deg=15.0, slope_heading_deg=45.0)
    assert not log.fell
    assert log.com[-1, 0] - log.com[0, 0] > 0.7
