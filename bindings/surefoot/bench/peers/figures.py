"""Figures of two sides that computed the same ticks."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from surefoot.bench.figures import distribution
from surefoot.bench.peers.contestant import CPU, FORCES, SOLVED, TORQUES, WALL, Ticks

WEIGHT_SHARE = 0.03  # of the weight, by which any foot's force may differ while nobody pushes
TORQUE_SHARE = 0.05  # of the greatest torque then, by which answers may differ
SAME = "same answer"


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
    force = _apart(ours, theirs)
    calm_force = float(force[calm].max())
    torque = np.abs(ours[:, TORQUES:] - theirs[:, TORQUES:]).max(axis=1)
    greatest = float(np.abs(ours[calm, TORQUES:]).max())
    calm_torque = float(torque[calm].max())
    verdict = SAME
    if calm_force > WEIGHT_SHARE * weight:
        verdict = f"another answer: a foot's force differs by up to {calm_force:.3g} N"
    elif calm_torque > TORQUE_SHARE * greatest:
        verdict = (
            f"another answer: torques differ by up to {calm_torque:.3g} N.m of {greatest:.3g} N.m"
        )
    return {
        "verdict": verdict,
        "weight_n": round(weight, 3),
        "greatest_force_difference_n": _spread(force, calm),
        "greatest_torque_difference_nm": _spread(torque, calm),
        "ticks_apart": int(np.count_nonzero(torque > TORQUE_SHARE * greatest)),
        "greatest_calm_torque_nm": round(greatest, 6),
    }


def _apart(ours: Ticks, theirs: Ticks) -> NDArray[np.float64]:
    """Return how far the foot's force is that differs most, tick by tick [N]."""
    difference = (theirs - ours)[:, FORCES:TORQUES].reshape(len(ours), 4, 3)
    apart: NDArray[np.float64] = np.linalg.norm(difference, axis=2).max(axis=1)
    return apart


def _spread(difference: NDArray[np.float64], calm: NDArray[np.bool_]) -> dict[str, float]:
    return {
        "calm": round(float(difference[calm].max()), 6),
        "all": round(float(difference.max()), 6),
        "p90": round(float(np.percentile(difference, 90.0)), 6),
    }
