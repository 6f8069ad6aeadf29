"""Cost of a run: one number for how well a robot stood. walk_cost.py has that of a walk.

A term has the value 1 when an engineer beside the robot begins to notice the deviation. An
objective is a weighted sum of terms, limited to FALL_COST. A fall adds between FALL_COST and
2 FALL_COST, more if it is earlier. So a run with a fall always costs more than a run without.
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

# Limit of the weighted sum of terms, and smallest additional cost of a fall. Chosen: only the order
# of the costs matters.
FALL_COST = 100.0
# [s] Length of the intervals of rest: before the first push, and at the end. Chosen: shorter than
# FIRST_PUSH_TIME (0.6 s) minus the time that the estimator needs at its start (0.15 s), and long
# enough for frequencies above 30 Hz.
STILL_TIME = 0.4

# The weights are chosen by hand, not measured: an objective weights most what its name says.
OBJECTIVES: dict[str, dict[str, float]] = {
    "balance": {"sway": 1.0, "tilt": 1.0, "settle": 1.0, "feet": 0.5, "buzz": 0.5, "still": 0.5},
    "quiet": {"sway": 0.2, "tilt": 0.2, "settle": 0.2, "feet": 0.2, "buzz": 2.0, "still": 2.0},
    "power": {"sway": 0.3, "tilt": 0.3, "settle": 0.3, "feet": 0.2, "buzz": 0.3, "power": 2.0},
}
"""Weight of each term in each objective."""

TERMS = {
    "sway": "RMS displacement of the base from its first position, relative to the feet / 10 mm",
    "tilt": "RMS angle of the base from its first orientation / 1 deg",
    "settle": "mean time from the end of a push until the robot has settled / 0.5 s",
    "feet": "greatest displacement of a foot from its first position / 10 mm",
    "buzz": "RMS torque above 30 Hz of the worst motor while still / 1 % of its limit",
    "still": "RMS joint velocity while still / 0.01 rad/s",
    "power": "mean of sum |tau dq| / power that lifts the robot at 10 mm/s",
}
"""Definition of each term, as a quantity / the value of this quantity that gives 1."""


@dataclass(frozen=True)
class Cost:
    """Cost of a run; lower is better.

    Attributes:
        value: Weighted sum of the terms, plus terms["fall"].
        terms: All terms of TERMS or WALK_TERMS, and "fall". terms["fall"] is 0 without a fall, else
            FALL_COST to 2 FALL_COST.
    """

    value: float
    terms: dict[str, float]


def cost(trace: Trace, objective: str = "balance", expected_rows: int | None = None) -> Cost:
    """Compute the cost of a trace.

    Args:
        trace: State of the plant in every control period; its first row is the reference pose.
        objective: One of OBJECTIVES.
        expected_rows: Planned number of rows. None: the number of rows of the trace. A fall costs
            more if fewer of the planned rows exist.

    Raises:
        Error: The objective is unknown, or the trace has no rows.
    """
    weights = objective_weights(objective, OBJECTIVES)
    if len(trace) == 0:
        raise Error("cost: got a trace without rows, expected at least one")
    share = len(trace) / max(expected_rows or len(trace), 1)
    return weighted_cost(_cost_terms(trace), weights, trace.fell, share)


def weighted_cost(
    terms: dict[str, float], weights: dict[str, float], fell: bool, share: float
) -> Cost:
    """Return the cost of a run.

    Args:
        terms: Value of each term; may be NaN or infinite.
        weights: Weight of each term of the objective.
        fell: Whether the robot fell.
        share: Share of the planned run that was simulated, 0 .. 1.
    """
    fall = FALL_COST * (2.0 - min(share, 1.0)) if fell else 0.0
    # A diverged simulation makes terms NaN or infinite. Replace each such term by FALL_COST.
    terms = {
        name: float(np.nan_to_num(term, nan=FALL_COST, posinf=FALL_COST))
        for name, term in {**terms, "fall": fall}.items()
    }
    value = min(sum(weights[name] * terms[name] for name in weights), FALL_COST) + fall
    return Cost(value, terms)


def objective_weights(objective: str, objectives: dict[str, dict[str, float]]) -> dict[str, float]:
    """Return the weights of one of the objectives; raise Error if the name is unknown."""
    if objective not in objectives:
        raise Error(f"objective: got '{objective}', expected one of {', '.join(objectives)}")
    return objectives[objective]


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
    """Return the rows of both intervals of rest (see STILL_TIME); all rows if there are none."""
    count, rows = round(STILL_TIME * trace.rate), len(trace)
    pushed = np.flatnonzero(trace.column("push") > 0.0)
    first = int(pushed[0]) if len(pushed) else rows
    parts = [slice(max(0, first - count), first), slice(max(0, rows - count), rows)]
    return [part for part in parts if part.stop - part.start >= count // 2] or [slice(0, rows)]


def _settling_time(trace: Trace, displacement: Array, angle: Array) -> float:
    """Return the mean time [s] from the end of a push until the robot has settled.

    The time of each push is limited to the time until the next push.
    """
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
