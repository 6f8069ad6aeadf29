# SPDX-License-Identifier: BSD-3-Clause
"""After a push, gains 20 % inside the predicted boundary come to rest; 20 % outside do not."""

from __future__ import annotations

import dataclasses
import functools

import pytest

pytest.importorskip("casadi")

from design_helpers import GOAL, body_of, comes_to_rest, gains_with_factor
from plant_helpers import ROBOTS
from surefoot.tune.design import AXES, ClosedLoop, Observers, Timing, oscillation_boundary

pytestmark = pytest.mark.slow

DELAYS = (0.004, 0.012)  # [s]


@functools.cache
def boundaries(robot: str, axis: str, delay: float) -> dict[str, float]:
    body = body_of(robot)
    observers = Observers.of(body.robot.config.gains)
    return {
        direction.name: oscillation_boundary(
            ClosedLoop(direction, Timing(delay=delay), observers), GOAL.kp, GOAL.kd
        )
        for direction in body.axis_directions(axis)
    }


@pytest.mark.parametrize("delay", DELAYS)
@pytest.mark.parametrize("axis", AXES)
@pytest.mark.parametrize("robot", ROBOTS)
def test_gains_20_percent_inside_the_boundary_come_to_rest(
    robot: str, axis: str, delay: float
) -> None:
    factor = 0.8 * min(boundaries(robot, axis, delay).values())
    gains = gains_with_factor(robot, axis, factor)
    for direction in body_of(robot).axis_directions(axis):
        assert comes_to_rest(robot, delay, gains, direction), direction.name


@pytest.mark.parametrize("delay", DELAYS)
@pytest.mark.parametrize("axis", AXES)
@pytest.mark.parametrize("robot", ROBOTS)
def test_gains_20_percent_outside_the_boundary_keep_oscillating(
    robot: str, axis: str, delay: float
) -> None:
    found = boundaries(robot, axis, delay)
    weakest = min(found, key=lambda name: found[name])
    gains = gains_with_factor(robot, axis, 1.2 * found[weakest])
    there = body_of(robot).directions[weakest]
    back = dataclasses.replace(there, push_velocity=-there.push_velocity)
    # Joint friction may stop the body after one push by chance, but not after both.
    assert not all(comes_to_rest(robot, delay, gains, direction) for direction in (there, back))
