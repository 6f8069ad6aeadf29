"""One number for how well a robot stood: what it weighs, and in which units.

A term of 1 is what an engineer who stands beside the robot begins to mind. Objectives are weighted
sums of terms, FALL at most; a fall costs FALL more, and up to as much again the sooner it comes, so
that no robot that stands costs more than one that falls.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from surefoot._core import Error
from surefoot.geometry.rotations import Array
from surefoot.stand.foot_frame import pose_from_feet, rotation_angle
from surefoot.stand.settling import SETTLED_ANGLE, SETTLED_DISTANCE, SETTLED_SPEED
from surefoot.stand.spectrum import high_frequency_rms
from surefoot.tune.trace import Trace

FALL_COST = 100.0
STILL_TIME = 0.4  # [s] before the first push and at the end in which the robot is to be still

OBJECTIVES: dict[str, dict[str, float]] = {
    "balance": {"sway": 1.0, "tilt": 1.0, "settle": 1.0, "feet": 0.5, "buzz": 0.5, "still": 0.5},
    "quiet": {"sway": 0.2, "tilt": 0.2, "settle": 0.2, "feet": 0.2, "buzz": 2.0, "still": 2.0},
    "power": {"sway": 0.3, "tilt": 0.3, "settle": 0.3, "feet": 0.2, "buzz": 0.3, "power": 2.0},
}
"""Weight of every term in every objective."""

TERMS = {
    "sway": "RMS way of the base from where it stood, relative to the feet / 10 mm",
    "tilt": "RMS angle of the base from how it stood / 1 deg",
    "settle": "mean time from a push's end until the robot stands again / 0.5 s",
    "feet": "greatest way of a foot from where it stood / 10 mm",
    "buzz": "RMS torque above 30 Hz of the worst motor while still / 1 % of its limit",
    "still": "RMS joint velocity while still / 0.01 rad/s",
    "power": "mean of sum |tau dq| / what lifting the robot by 10 mm/s takes",
}
"""What each term is, and what is 1."""


@dataclass(frozen=True)
class Cost:
    """How badly a robot stood; lower is better.

    Attributes:
        value: The weighted sum, and what a fall adds.
        terms: Every term of TERMS, and "fall": 0, or FALL and up to as much again.
    """

    value: float
    terms: dict[str, float]


def cost(trace: Trace, objective: str = "balance", expected_rows: int | None = None) -> Cost:
    """Judge a trace.

    Args:
        trace: Rows since the robot last stood still.
        objective: One of OBJECTIVES.
        expected_rows: Rows that the run was to have; a run that a fall cut short is dearer by what is missing.

    Raises:
        Error: An unknown objective, or no row.
    """
    weights = objective_weights(objective)
    if len(trace) == 0:
        raise Error("cost: got a trace without rows, expected at least one")
    terms = _cost_terms(trace)
    whole = max(expected_rows or len(trace), 1)
    terms["fall"] = FALL_COST * (2.0 - min(len(trace) / whole, 1.0)) if trace.fell else 0.0
    # A state that is not a number is a fall, and its terms are none.
    terms = {
        name: float(np.nan_to_num(term, nan=FALL_COST, posinf=FALL_COST))
        for name, term in terms.items()
    }
    value = min(sum(weights[name] * terms[name] for name in weights), FALL_COST) + terms["fall"]
    return Cost(value, terms)


def objective_weights(objective: str) -> dict[str, float]:
    """Return an objective's weights; raises Error with the valid names."""
    if objective not in OBJECTIVES:
        raise Error(f"objective: got '{objective}', expected one of {', '.join(OBJECTIVES)}")
    return OBJECTIVES[objective]


def _cost_terms(trace: Trace) -> dict[str, float]:
    base, feet = trace.column("base"), trace.column("feet")
    q = base[:, [0, 1, 2, 4, 5, 6, 3]]
    pose = pose_from_feet(q, np.moveaxis(feet, 1, 2))
    displacement = np.linalg.norm(pose.position - pose.position[0], axis=1)
    angle = rotation_angle(pose.rotation[0].T @ pose.rotation)
    tau, dq, still = trace.column("tau"), trace.column("dq"), _still_rows(trace)
    buzz = [high_frequency_rms(tau[rows], trace.rate) / trace.tau_max for rows in still]
    return {
        "sway": _rms(displacement) / 0.010,
        "tilt": np.degrees(_rms(angle)) / 1.0,
        "settle": _settling_time(trace, displacement, angle) / 0.5,
        "feet": np.linalg.norm(feet - feet[0], axis=2).max() / 0.010,
        "buzz": float(np.nan_to_num(np.max(buzz))) / 0.01,
        "still": _rms(np.concatenate([dq[rows].ravel() for rows in still])) / 0.01,
        "power": np.abs(tau * dq).sum(axis=1).mean() / (0.010 * trace.weight),
    }


def _still_rows(trace: Trace) -> list[slice]:
    """Return the rows before the first push, and the last ones, in which nothing moves."""
    count, rows = round(STILL_TIME * trace.rate), len(trace)
    pushed = np.flatnonzero(trace.column("push") > 0.0)
    first = int(pushed[0]) if len(pushed) else rows
    parts = [slice(max(0, first - count), first), slice(max(0, rows - count), rows)]
    return [part for part in parts if part.stop - part.start >= count // 2] or [slice(0, rows)]


def _settling_time(trace: Trace, displacement: Array, angle: Array) -> float:
    """Return the mean time from a push's end until the robot stands, or the next push, [s]."""
    push = trace.column("push") > 0.0
    push_ends = np.flatnonzero(push[:-1] & ~push[1:]) + 1
    if len(push_ends) == 0:
        return 0.0
    push_starts = np.append(np.flatnonzero(~push[:-1] & push[1:]) + 1, len(push))
    speed = np.linalg.norm(trace.column("velocity"), axis=1)
    is_settled = (
        (displacement <= SETTLED_DISTANCE) & (angle <= SETTLED_ANGLE) & (speed < SETTLED_SPEED)
    )
    times = []
    for end in push_ends:
        until = int(push_starts[push_starts > end][0])
        unsettled = np.flatnonzero(~is_settled[end:until])
        times.append(0 if len(unsettled) == 0 else unsettled[-1] + 1)
    return float(np.mean(times)) / trace.rate


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(np.square(values))))
