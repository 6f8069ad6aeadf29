"""Strides of each foot: time, duty factor and length."""

from __future__ import annotations

from typing import Any

import numpy as np

from surefoot.estimate.contact_events import THRESHOLD, joined_stances
from surefoot.estimate.estimate_result import Estimate
from surefoot.estimate.foot_motion import foot_motion
from surefoot.geometry.batch_rotations import Array
from surefoot.messages.low_state_layout import LEGS

# [s] Longest stride. Chosen: slower than every gait of a quadruped; a longer one has a stop in it.
MAX_STRIDE_TIME = 2.0


def stride_summary(estimate: Estimate) -> dict[str, Any]:
    """Return the medians over the strides of each foot.

    A stride goes from a touch-down to the next one. Its length is the horizontal distance between
    the places of the foot in the middle of the two stances.
    """
    return {leg: _foot_strides(estimate, k) for k, leg in enumerate(LEGS)}


def _foot_strides(estimate: Estimate, leg: int) -> dict[str, Any]:
    stances = joined_stances(estimate.time, estimate.contact[:, leg] > THRESHOLD)
    inner = [(a, b) for a, b in stances if a > 0 and b < len(estimate.time)]
    times, duties, lengths = [], [], []
    places = _places(estimate, leg, [(a + b) // 2 for a, b in inner])
    for k in range(len(inner) - 1):
        (touchdown, liftoff), (following, _) = inner[k], inner[k + 1]
        time = estimate.time[following] - estimate.time[touchdown]
        if time <= MAX_STRIDE_TIME:
            times.append(time)
            duties.append((estimate.time[liftoff] - estimate.time[touchdown]) / time)
            lengths.append(np.linalg.norm(places[k + 1] - places[k]))
    return {
        "strides": len(times),
        "stride_time_s": _median(times),
        "duty": _median(duties),
        "step_length_m": _median(lengths),
    }


def _places(estimate: Estimate, leg: int, rows: list[int]) -> Array:
    """Return the horizontal positions (k, 2) [m] of a foot in some rows, world axes."""
    if not rows:
        return np.zeros((0, 2))
    q = estimate.q[rows][:, list(estimate.robot.motor_to_q)]
    centre = foot_motion(estimate.robot, q, np.zeros_like(q)).centre[:, leg]
    world = estimate.q[rows, :3] + np.einsum("nij,nj->ni", estimate.rotation[rows], centre)
    return np.asarray(world[:, :2])


def _median(values: list[Any]) -> float | None:
    return float(np.median(values)) if values else None
