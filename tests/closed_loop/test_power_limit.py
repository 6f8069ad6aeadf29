# SPDX-License-Identifier: BSD-3-Clause
"""A power limit of 90 % of the power protection's level, checked by the protection."""

from __future__ import annotations

from dataclasses import dataclass

import pytest
import surefoot
from surefoot.sim import Plant, PlantSettings, Push

pytestmark = pytest.mark.slow


@dataclass
class Outcome:
    """Outcome of a pushed run.

    Attributes:
        fell: True if the robot fell.
        measured: Largest power that the power protection computed [W].
        commanded: Largest power of the commands [W].
        limited: Number of ticks whose torques the limit has reduced.
        over: Number of ticks with a command power above the limit.
        refused: Number of ticks in which the power protection tripped.
    """

    fell: bool = False
    measured: float = 0.0
    commanded: float = 0.0
    limited: int = 0
    over: int = 0
    refused: int = 0


def pushed(name: str, direction: str, share: float, level: int, limit: float) -> Outcome:
    plant = Plant(name, PlantSettings(seed=2))
    plant.add_push(Push(direction, share * plant.lip_push_limit(direction), 0.1, 0.5))
    options = surefoot.ControllerOptions(power_limit=limit)
    controller = surefoot.StandController(plant.robot, plant.robot.config.gains, options)
    safety, report, outcome = surefoot.Safety(plant.robot), plant.reset(), Outcome()
    for _ in range(1000):
        command = controller.update(report)
        outcome.refused += safety.power_protect(command, report, level) < 0
        outcome.limited += controller.command_power > 0.999 * limit
        outcome.over += controller.command_power > limit
        outcome.measured = max(outcome.measured, safety.power)
        outcome.commanded = max(outcome.commanded, controller.command_power)
        report = plant.step(command)
    outcome.fell = plant.truth.fell
    return outcome


@pytest.mark.parametrize("direction", ["lateral", "forward"])
@pytest.mark.parametrize("name", ["a1", "go1", "go2"])
def test_50_percent_push_needs_less_than_40_w(name: str, direction: str) -> None:
    outcome = pushed(name, direction, 0.5, level=1, limit=90.0)
    assert not outcome.fell
    assert (outcome.refused, outcome.limited) == (0, 0)
    assert 2.0 < outcome.measured < 40.0


@pytest.mark.parametrize("share", [0.92, 0.96])
def test_power_limit_prevents_power_protection_trips(share: float) -> None:
    free = pushed("b1", "forward", share, level=10, limit=float("inf"))
    assert free.refused > 0
    limited = pushed("b1", "forward", share, level=10, limit=900.0)
    assert (limited.fell, limited.refused) == (False, 0)
    assert limited.limited > 0
    # On two feet, holding alone can need more power for 10 ms; torques are not scaled then.
    assert limited.over <= 5


def test_robot_too_heavy_for_its_power_limit_keeps_standing() -> None:
    outcome = pushed("b1", "forward", 0.8, level=1, limit=90.0)
    assert not outcome.fell
    assert outcome.refused > 0
    assert outcome.commanded > 90.0
