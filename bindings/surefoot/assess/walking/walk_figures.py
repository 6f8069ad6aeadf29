"""Figures of one walk from a stand to a stand, from its true motion."""

from __future__ import annotations

from typing import Any

import numpy as np

from surefoot._core import Robot
from surefoot.assess.walking.true_walk import TrueWalk
from surefoot.stand.settling import SETTLED_SPEED
from surefoot.walk.commands import SETTLING, window_figures
from surefoot.walk.metrics import STANDING_TIME, foot_displacement
from surefoot.walk.steps import LOADED, slip_per_step, stance_phases, touchdown_force

# Share of a motor's torque limit from which on it counts as saturated. Chosen: above the torque
# errors of the plant's motors (Flaws.torque_error), below what their lag leaves of a limit.
SATURATED = 0.95


def walk_figures(walk: TrueWalk, robot: Robot, begin: float, end: float) -> dict[str, Any]:
    """Return the figures of a walk by name; docs/reference/scorecard.md describes them.

    A figure is None if the robot fell before its ticks.

    Args:
        walk: True motion.
        robot: Model of the robot, for its standing pose.
        begin: Time from which on the velocity is commanded [s].
        end: Time from which on it is 0 again [s].
    """
    last = min(round(end * walk.rate), len(walk.tau))
    window = slice(round((begin + SETTLING) * walk.rate), last)
    slip = slip_per_step(walk)
    saturated = (np.abs(walk.tau) >= SATURATED * walk.torque_limit).any(axis=1)
    stands = _stands(walk)
    return {
        "fell": walk.fell,
        "stands_at_end": stands,
        "stance_error_mm": 1000.0 * foot_displacement(robot, walk.feet[-1]) if stands else None,
        **window_figures(walk, window),
        "steps": sum(phase.stepped for phase in stance_phases(walk)),
        "slip_mm_per_step": None if slip is None else 1000.0 * slip,
        "touchdown_force_mg": touchdown_force(walk),
        "leg_contacts": walk.leg_contacts.sum(),
        "saturated_percent": 100.0 * saturated.mean(),
        "peak_power_w": np.abs(walk.tau * walk.dq).sum(axis=1).max(),
    }


def _stands(walk: TrueWalk) -> bool:
    """Return whether four feet are loaded and the base is slow at the end.

    The commands of the controller are unknown, so a robot that steps in place is found by its
    unloaded feet.
    """
    last = slice(-round(STANDING_TIME * walk.rate), None)
    return bool(
        not walk.fell
        and (walk.normal_forces[last] > LOADED * walk.weight).all()
        and (np.linalg.norm(walk.v_true[last, :3], axis=1) < SETTLED_SPEED).all()
    )
