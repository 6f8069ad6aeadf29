# SPDX-License-Identifier: BSD-3-Clause
"""Near the edge of balance feet are put where they catch the body, and only if they must."""

from __future__ import annotations

import numpy as np
import pytest
from surefoot import StandController, load_robot
from surefoot.assess import Condition, Contestant
from surefoot.assess.push_limits import Limits
from surefoot.assess.push_run import Outcome, judge
from surefoot.assess.rollout import Track
from surefoot.assess.unit import PushUnit
from surefoot.gain_files import gain_values, gains_of

LEVEL = Condition("level ground")
STILL = 0.002  # [m] that feet and base move by at most in the last half second
HARD = ((157.5, 2), (202.5, 2))  # heading [deg] and seed, b1's
SMALL = [(heading, level) for heading in (67.5, 90.0, 112.5, 157.5) for level in (110.0, 120.0)]


def pushed(
    heading: float, seed: int, level: float, foot_step: float, name: str = "b1"
) -> tuple[Track, Outcome]:
    """Push a robot for 0.1 s by a share of its own limit [%]."""
    robot = load_robot(name)
    gains = gains_of({**gain_values(robot.config.gains), "foot_step": foot_step})
    limit = Limits(robot).of(LEVEL, heading, 0.1, 0.0).own
    unit = PushUnit(LEVEL, heading, 0.1, 0.0, seed, limit)
    contestant = Contestant("stepping", factory=lambda _: StandController(robot, gains))
    track = unit.play(name, contestant, level)
    return track, judge(track, LEVEL.quiet_s, 0.1)


@pytest.mark.parametrize(("heading", "seed"), HARD)
def test_a_push_that_throws_its_feet_up_is_survived_by_stepping(heading: float, seed: int) -> None:
    foot_step = load_robot("b1").config.gains.foot_step
    track, outcome = pushed(heading, seed, 97.5, foot_step)
    assert outcome.survived and outcome.foot_mm > 50.0
    last = slice(-round(0.5 * track.rate), None)
    assert np.ptp(track.base[last, :3], axis=0).max() < STILL
    assert np.ptp(track.feet[last], axis=0).max() < STILL


# They survive about as many with feet that are called back, and must not fall by stepping.
@pytest.mark.parametrize("robot", ["a1", "go1", "go2"])
def test_small_robots_step_too_and_lose_nothing_by_it(robot: str) -> None:
    foot_step = load_robot(robot).config.gains.foot_step
    stepped = [pushed(heading, 0, level, foot_step, robot)[1] for heading, level in SMALL]
    held = [pushed(heading, 0, level, 0.0, robot)[1] for heading, level in SMALL]
    assert sum(o.survived for o in stepped) >= sum(o.survived for o in held) - 1
    assert any(o.survived and o.foot_mm > 50.0 for o in stepped)


def test_with_its_feet_called_back_to_where_they_were_it_falls() -> None:
    assert not any(pushed(*push, 97.5, 0.0)[1].survived for push in HARD)


@pytest.mark.parametrize("heading", [0.0, 22.5, 157.5, 202.5])
def test_what_feet_that_stay_can_brake_moves_none(heading: float) -> None:
    foot_step = load_robot("b1").config.gains.foot_step
    assert pushed(heading, 0, 75.0, foot_step)[1].strict
