"""Level of the SDK's power protection for each robot."""

from __future__ import annotations

# A level is 100 W (SDK). At level 1, a b1 stands, but pushes trip the protection
# (docs/first-day.md). A b2 is heavier than a b1.
POWER_LEVELS = {"b1": 10, "b2": 10}  # level by robot name; power_level() returns 1 for all others


def power_level(robot: str) -> int:
    """Return the level of the power protection for a robot, 1 .. 10."""
    return POWER_LEVELS.get(robot, 1)
