# SPDX-License-Identifier: BSD-3-Clause
"""Pushes at the robots' own limits, where they used to turn over their last foot."""

from __future__ import annotations

import pytest
import surefoot
from surefoot.assess.condition import Condition
from surefoot.assess.contestant import Contestant
from surefoot.assess.push_limits import Limits
from surefoot.assess.push_run import Outcome, judge
from surefoot.assess.unit import PushUnit

LEVEL = Condition("level")


def push(robot: str, degrees: float, level: float, seed: int) -> Outcome:
    """Push one robot for 0.1 s by a share of its own limit [%]."""
    limit = Limits(surefoot.load_robot(robot)).of(LEVEL, degrees, 0.1, 0.0).own
    unit = PushUnit(LEVEL, degrees, 0.1, 0.0, seed, limit)
    return judge(unit.play(robot, Contestant(), level), LEVEL.quiet_s, unit.duration)


@pytest.mark.parametrize("robot", ["a1", "go1", "go2"])
@pytest.mark.parametrize("degrees", [22.5, 157.5, 202.5, 337.5])
def test_a_small_robot_survives_its_own_limit(robot: str, degrees: float) -> None:
    """A stretched leg that bears nothing used to hold the body: a go2 fell at 97.5 %."""
    for seed in range(2):
        assert push(robot, degrees, 100.0, seed).survived, seed


@pytest.mark.parametrize("robot", ["a1", "go1", "go2", "b1"])
@pytest.mark.parametrize("degrees", [22.5, 157.5])
def test_no_foot_moves_at_three_quarters_of_it(robot: str, degrees: float) -> None:
    outcome = push(robot, degrees, 75.0, 0)
    assert outcome.strict, outcome
