"""The level of the SDK's power protection that each robot is run with."""

from __future__ import annotations

POWER_LEVELS = {"b1": 10}  # of the power protection; 1 for all others


def power_level(robot: str) -> int:
    """Return the level of the power protection that a robot is run with."""
    return POWER_LEVELS.get(robot, 1)
