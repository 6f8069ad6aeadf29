# SPDX-License-Identifier: BSD-3-Clause
"""Recovery steps save robots from strong pushes; no foot steps at weaker pushes."""

from __future__ import annotations

import numpy as np
import pytest
from surefoot import StandController, load_robot
from surefoot.assess import Condition, ControllerUnderTest
from surefoot.assess.push_limits import PushLimits
from surefoot.assess.push_outcome import PushOutcome, judge_push
from surefoot.assess.rollout import TrueTrajectory
from surefoot.assess.work_units import PushUnit
from surefoot.robot.gain_files import gain_values, gains_from_values

pytestmark = pytest.mark.slow

LEVEL_GROUND = Condition("level ground")
STILL_DISTANCE = 0.002  # [m] largest motion of feet and base in the last 0.5 s
FOOT_LIFTING_PUSHES = ((157.5, 2), (202.5, 2))  # heading [deg] and seed, for b1
SMALL_ROBOT_PUSHES = [
    (heading, level) for heading in (67.5, 90.0, 112.5, 157.5) for level in (110.0, 120.0)
]


def pushed(
    heading: float, seed: int, level: float, foot_step: float, name: str = "b1"
) -> tuple[TrueTrajectory, PushOutcome]:
    """Push a robot for 0.1 s with `level` percent of its push limit."""
    robot = load_robot(name)
    gains = gains_from_values({**gain_values(robot.config.gains), "foot_step": foot_step})
    limit = PushLimits(robot).push_limit(LEVEL_GROUND, heading, 0.1, 0.0).limit
    unit = PushUnit(LEVEL_GROUND, heading, 0.1, 0.0, seed, limit)
    controller_under_test = ControllerUnderTest(
        "stepping", factory=lambda _: StandController(robot, gains)
    )
    trajectory = unit.simulate(name, controller_under_test, level)
    return trajectory, judge_push(trajectory, LEVEL_GROUND.quiet_s, 0.1)


@pytest.mark.parametrize(("heading", "seed"), FOOT_LIFTING_PUSHES)
def test_b1_survives_a_97_5_percent_push_by_stepping(heading: float, seed: int) -> None:
    foot_step = load_robot("b1").config.gains.foot_step
    trajectory, outcome = pushed(heading, seed, 97.5, foot_step)
    assert outcome.survived and outcome.foot_mm > 50.0
    last = slice(-round(0.5 * trajectory.rate), None)
    assert np.ptp(trajectory.base[last, :3], axis=0).max() < STILL_DISTANCE
    assert np.ptp(trajectory.feet[last], axis=0).max() < STILL_DISTANCE


# Small robots survive about as many pushes without steps; stepping must not make them fall.
@pytest.mark.parametrize("robot", ["a1", "go1", "go2"])
def test_small_robots_survive_as_many_pushes_with_steps_as_without(robot: str) -> None:
    foot_step = load_robot(robot).config.gains.foot_step
    stepped = [
        pushed(heading, 0, level, foot_step, robot)[1] for heading, level in SMALL_ROBOT_PUSHES
    ]
    held = [pushed(heading, 0, level, 0.0, robot)[1] for heading, level in SMALL_ROBOT_PUSHES]
    assert sum(o.survived for o in stepped) >= sum(o.survived for o in held) - 1
    assert any(o.survived and o.foot_mm > 50.0 for o in stepped)


def test_b1_falls_at_a_97_5_percent_push_without_steps() -> None:
    assert not any(pushed(*push, 97.5, 0.0)[1].survived for push in FOOT_LIFTING_PUSHES)


@pytest.mark.parametrize("heading", [0.0, 22.5, 157.5, 202.5])
def test_no_foot_steps_at_a_75_percent_push(heading: float) -> None:
    foot_step = load_robot("b1").config.gains.foot_step
    assert pushed(heading, 0, 75.0, foot_step)[1].in_place
