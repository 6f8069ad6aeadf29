# SPDX-License-Identifier: BSD-3-Clause
"""Pushes at the push limits of the robots."""

from __future__ import annotations

import pytest
import surefoot
from surefoot.assess.condition import Condition
from surefoot.assess.controller_under_test import ControllerUnderTest
from surefoot.assess.push_limits import PushLimits
from surefoot.assess.push_outcome import PushOutcome, judge_push
from surefoot.assess.work_units import PushUnit

pytestmark = pytest.mark.slow

LEVEL_GROUND = Condition("level")


def push(robot: str, direction_deg: float, level: float, seed: int) -> PushOutcome:
    """Push a robot for 0.1 s with `level` percent of its push limit."""
    limit = (
        PushLimits(surefoot.load_robot(robot))
        .push_limit(LEVEL_GROUND, direction_deg, 0.1, 0.0)
        .limit
    )
    unit = PushUnit(LEVEL_GROUND, direction_deg, 0.1, 0.0, seed, limit)
    return judge_push(
        unit.simulate(robot, ControllerUnderTest(), level), LEVEL_GROUND.quiet_s, unit.duration
    )


@pytest.mark.parametrize("robot", ["a1", "go1", "go2"])
@pytest.mark.parametrize("direction_deg", [22.5, 157.5, 202.5, 337.5])
def test_small_robots_survive_a_100_percent_push(robot: str, direction_deg: float) -> None:
    """A stretched leg without load must not hold the body back."""
    for seed in range(2):
        assert push(robot, direction_deg, 100.0, seed).survived, seed


@pytest.mark.parametrize("robot", ["a1", "go1", "go2", "b1"])
@pytest.mark.parametrize("direction_deg", [22.5, 157.5])
def test_no_foot_moves_at_a_75_percent_push(robot: str, direction_deg: float) -> None:
    outcome = push(robot, direction_deg, 75.0, 0)
    assert outcome.in_place, outcome
