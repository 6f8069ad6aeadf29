"""Figures of two sides that computed the same ticks."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from surefoot.bench.figures import distribution
from surefoot.bench.peers.contestant import CPU, FORCES, SOLVED, TORQUES, WALL, Ticks

WEIGHT_SHARE = 0.03  # by which forces on all feet may differ while nobody pushes
TORQUE_SHARE = 0.05  # of the greatest torque then, by which answers may differ


def median_ratio(ours: Ticks, theirs: Ticks, clock: int = WALL) -> float:
    """Return the median over ticks k of ours[k] / theirs[k]."""
    return round(float(np.median(ours[:, clock] / np.maximum(theirs[:, clock], 1.0))), 4)


def times(ticks: Ticks) -> dict[str, Any]:
    """Return how long the ticks took, and how many were not solved."""
    return {
        "wall_us": distribution(ticks[:, WALL] / 1000.0),
        "cpu_us": distribution(ticks[:, CPU] / 1000.0),
        "failures": int(np.count_nonzero(ticks[:, SOLVED] == 0.0)),
    }


def answers(ours: Ticks, theirs: Ticks, weight: float, calm: NDArray[np.bool_]) -> dict[str, Any]:
    """Compare forces and torques.

    Args:
        ours: State to torque.
        theirs: The same ticks.
        weight: Of the robot [N].
        calm: Which ticks are before any push.

    Returns:
        Forces, greatest differences, in how many ticks torques differ by more than TORQUE_SHARE,
        and in "verdict" in words whether the answer is the same while nobody pushes.
    """
    vertical = slice(FORCES + 2, TORQUES, 3)
    forces = [float(side[calm, vertical].sum(axis=1).mean()) for side in (ours, theirs)]
    torque = np.abs(ours[:, TORQUES:] - theirs[:, TORQUES:]).max(axis=1)
    greatest = float(np.abs(ours[calm, TORQUES:]).max())
    calm_torque = float(torque[calm].max())
    verdict = "same answer"
    if abs(forces[1] - forces[0]) > WEIGHT_SHARE * weight:
        verdict = f"another answer: carries {forces[1]:.1f} N where ours carries {forces[0]:.1f} N"
    elif calm_torque > TORQUE_SHARE * greatest:
        verdict = (
            f"another answer: torques differ by up to {calm_torque:.3g} N.m of {greatest:.3g} N.m"
        )
    return {
        "verdict": verdict,
        "weight_n": round(weight, 3),
        "calm_vertical_force_n": {"ours": round(forces[0], 3), "theirs": round(forces[1], 3)},
        "greatest_torque_difference_nm": {
            "calm": round(calm_torque, 6),
            "all": round(float(torque.max()), 6),
            "p90": round(float(np.percentile(torque, 90.0)), 6),
        },
        "ticks_apart": int(np.count_nonzero(torque > TORQUE_SHARE * greatest)),
        "greatest_calm_torque_nm": round(greatest, 6),
    }
