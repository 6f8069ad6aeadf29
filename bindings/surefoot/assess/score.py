"""The card filled in: what came of every unit, as plain JSON types."""

from __future__ import annotations

from typing import Any

from surefoot._core import Robot
from surefoot.assess.push_limits import Limits
from surefoot.assess.push_score import push_section
from surefoot.assess.settings import AssessSettings
from surefoot.bench.machine import describe_machine
from surefoot.plain import plain

Results = dict[tuple[str, str], dict[str, Any]]
"""What is in the store, by contestant and key."""


def score(
    settings: AssessSettings, robot: Robot, limits: Limits, results: Results
) -> dict[str, Any]:
    """Return the filled card."""
    pinned = limits.pinned
    filled = {
        "robot": robot.name,
        "controller": settings.contestant.name,
        "card": settings.card.name,
        "pinned_pose": {
            "q_standing": list(robot.config.q_standing),
            "mass_kg": pinned.mass,
            "com_height_m": pinned.height,
            "reach_forward_m": pinned.reach(0.0),
            "reach_lateral_m": pinned.reach(90.0),
        },
        "push": push_section(settings.card, settings.contestant.name, limits, results),
        "settings": settings.described(robot),
        "versions": describe_machine()["versions"],
    }
    result: dict[str, Any] = plain(filled)
    return result
