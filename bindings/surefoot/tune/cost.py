"""One number for how well a robot stood: what it weighs, and in which units.

A term of 1 is what an engineer who stands beside the robot begins to mind. Objectives are weighted
sums of terms, FALL at most; a fall costs FALL more, and up to as much again the sooner it comes, so
that no robot that stands costs more than one that falls.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from surefoot._core import Error
from surefoot.sim.rotations import Array
from surefoot.stand.geometry import pose_from_feet, rotation_angle
from surefoot.stand.settling import SETTLED_ANGLE, SETTLED_DISTANCE, SETTLED_SPEED
from surefoot.stand.spectrum import high_frequency_rms
from surefoot.tune.trace import Trace

FALL = 100.0
STILL = 0.4  # [s] before the first push and at the end in which the robot is to be still

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


def cost(trace: Trace, objective: str = "balance", of: int | None = None) -> Cost:
    """Judge a trace.

    Args:
        trace: Rows since the robot last stood still.
        objective: One of OBJECTIVES.
        of: Rows that the run was to have; a run that a fall cut short is dearer by what is missing.

    Raises:
        Error: An unknown objective, or no row.
    """
    weights = weights_of(objective)
    if len(trace) == 0:
        raise Error("cost: got a trace without rows, expected at least one")
    terms = _terms(trace)
    whole = max(of or len(trace), 1)
    terms["fall"] = FALL * (2.0 - min(len(trace) / whole, 1.0)) if trace.fell else 0.0
    # A state that is not a number is a fall, and its terms are none.
    terms = {
        name: float(np.nan_to_num(term, nan=FALL, posinf=FALL)) for name, term in terms.items()
    }
    value = min(sum(weights[name] * terms[name] for name in weights), FALL) + terms["fall"]
    return Cost(value, terms)


def weights_of(objective: str) -> dict[str, float]:
    """Return an objective's weights; raises Error with the valid names."""
    if objective not in OBJECTIVES:
        raise Error(f"objective: got '{objective}', expected one of {', '.join(OBJECTIVES)}")
    return OBJECTIVES[objective]


def _terms(trace: Trace) -> dict[str, float]:
    base, feet = trace.rows("base"), trace.rows("feet")
    q = base[:, [0, 1, 2, 4, 5, 6, 3]]
    pose = pose_from_feet(q, np.moveaxis(feet, 1, 2))
    moved = np.linalg.norm(pose.position - pose.position[0], axis=1)
    turned = rotation_angle(pose.rotation[0].T @ pose.rotation)
    tau, dq, still = trace.rows("tau"), trace.rows("dq"), _still(trace)
    buzz = [high_frequency_rms(tau[rows], trace.rate) / trace.tau_max for rows in still]
    return {
        "sway": _rms(moved) / 0.010,
        "tilt": np.degrees(_rms(turned)) / 1.0,
        "settle": _settle(trace, moved, turned) / 0.5,
        "feet": np.linalg.norm(feet - feet[0], axis=2).max() / 0.010,
        "buzz": float(np.nan_to_num(np.max(buzz))) / 0.01,
        "still": _rms(np.concatenate([dq[rows].ravel() for rows in still])) / 0.01,
        "power": np.abs(tau * dq).sum(axis=1).mean() / (0.010 * trace.weight),
    }


def _still(trace: Trace) -> list[slice]:
    """Return the rows before the first push, and the last ones, in which nothing moves."""
    count, rows = round(STILL * trace.rate), len(trace)
    pushed = np.flatnonzero(trace.rows("push") > 0.0)
    first = int(pushed[0]) if len(pushed) else rows
    parts = [slice(max(0, first - count), first), slice(max(0, rows - count), rows)]
    return [part for part in parts if part.stop - part.start >= count // 2] or [slice(0, rows)]


def _settle(trace: Trace, moved: Array, turned: Array) -> float:
    """Return the mean time from a push's end until the robot stands, or the next push, [s]."""
    push = trace.rows("push") > 0.0
    ends = np.flatnonzero(push[:-1] & ~push[1:]) + 1
    if len(ends) == 0:
        return 0.0
    begins = np.append(np.flatnonzero(~push[:-1] & push[1:]) + 1, len(push))
    speed = np.linalg.norm(trace.rows("velocity"), axis=1)
    stands = (moved <= SETTLED_DISTANCE) & (turned <= SETTLED_ANGLE) & (speed < SETTLED_SPEED)
    times = []
    for end in ends:
        until = int(begins[begins > end][0])
        unsettled = np.flatnonzero(~stands[end:until])
        times.append(0 if len(unsettled) == 0 else unsettled[-1] + 1)
    return float(np.mean(times)) / trace.rate


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(np.square(values))))
