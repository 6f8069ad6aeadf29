"""Level of the SDK's power protection for each robot."""

from __future__ import annotations

POWER_LEVELS = {"b1": 10}  # 1 for all other robots


def power_level(robot: str) -> int:
    """Return the level of the power protection for a robot, 1 .. 10."""
    return POWER_LEVELS.get(robot, 1)
