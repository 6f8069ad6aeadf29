"""Figures of two sides that computed the same ticks."""

from __future__ import annotations

from typing import Any

import numpy as np

from surefoot.bench.peers.contestant import CPU, FORCES, SOLVED, TORQUES, WALL, Ticks
from surefoot.bench.timing import distribution

WEIGHT_SHARE = 0.03  # by which forces on all feet may differ while the robot stands quietly
TORQUE_SHARE = 0.05  # of the greatest quiet torque, by which answers may differ


def median_ratio(ours: Ticks, theirs: Ticks, clock: int = WALL) -> float:
    """Return the median over ticks k of ours[k] / theirs[k]."""
    return round(float(np.median(ours[:, clock] / np.maximum(theirs[:, clock], 1.0))), 4)


def times(ticks: Ticks) -> dict[str, Any]:
    """Return how long the ticks took, and how many were not solved."""
    return {
        "wall_us": distribution([int(t) for t in ticks[:, WALL]]),
        "cpu_us": distribution([int(t) for t in ticks[:, CPU]]),
        "failures": int(np.count_nonzero(ticks[:, SOLVED] == 0.0)),
    }


def answers(ours: Ticks, theirs: Ticks, weight: float, quiet: int) -> dict[str, Any]:
    """Compare forces and torques.

    Args:
        ours: State to torque.
        theirs: The same ticks.
        weight: Of the robot [N].
        quiet: How many ticks there are before anything is asked to move.

    Returns:
        Shares, greatest differences, and in "verdict" in words whether the answer is the same.
    """
    vertical = slice(FORCES + 2, TORQUES, 3)
    forces = [float(side[:quiet, vertical].sum(axis=1).mean()) for side in (ours, theirs)]
    torque = np.abs(ours[:, TORQUES:] - theirs[:, TORQUES:]).max(axis=1)
    greatest = float(np.abs(ours[:quiet, TORQUES:]).max())
    quiet_torque = float(torque[:quiet].max())
    verdict = "same answer"
    if abs(forces[1] - forces[0]) > WEIGHT_SHARE * weight:
        verdict = f"another answer: carries {forces[1]:.1f} N where ours carries {forces[0]:.1f} N"
    elif quiet_torque > TORQUE_SHARE * greatest:
        verdict = (
            f"another answer: torques differ by up to {quiet_torque:.3g} N.m of {greatest:.3g} N.m"
        )
    return {
        "verdict": verdict,
        "weight_n": round(weight, 3),
        "quiet_vertical_force_n": {"ours": round(forces[0], 3), "theirs": round(forces[1], 3)},
        "greatest_torque_difference_nm": {
            "quiet": round(quiet_torque, 6),
            "all": round(float(torque.max()), 6),
            "p90": round(float(np.percentile(torque, 90.0)), 6),
        },
        "greatest_quiet_torque_nm": round(greatest, 6),
    }
