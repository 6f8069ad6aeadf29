"""Message for a goal that cannot be stable, with the greatest stable frequency."""

from __future__ import annotations

import math
from collections.abc import Sequence

from surefoot.tune.design.directions import Direction
from surefoot.tune.design.goals import Goal
from surefoot.tune.design.margins import FREQUENCY_SEARCH_RANGE, max_stable_frequency
from surefoot.tune.design.timing import Observers, Timing


def unstable_goal_text(
    subject: str, goal: Goal, timing: Timing, directions: Sequence[Direction], observers: Observers
) -> str:
    """Return the message for a goal that cannot be stable.

    Args:
        subject: Beginning of the message. It names the axis and the origin of its gains.
        goal: The goal.
        timing: Timing of the loop.
        directions: Directions of the axis. The direction with the smallest stable frequency counts.
        observers: Observers of the estimator.
    """
    greatest = min(
        max_stable_frequency(direction, timing, observers, goal.damping) for direction in directions
    )
    return (
        f"{subject}{goal.frequency:.3g} Hz with damping {goal.damping:.3g} cannot be stable with "
        f"{1000.0 * timing.delay:g} ms of additional delay at {timing.rate:g} Hz; "
        f"{_range_hint(greatest, goal)}"
    )


def _range_hint(greatest: float, goal: Goal) -> str:
    least = FREQUENCY_SEARCH_RANGE[0]
    if greatest <= 0.0:
        return f"no frequency from {least:g} Hz up is stable at this damping"
    # Round down, so that the printed frequency is stable.
    most = f"{math.floor(100.0 * greatest) / 100.0:.2f} Hz at this damping"
    if greatest >= goal.frequency:
        return f"expected {least:g} .. {most}"
    return f"expected at most {most}"
