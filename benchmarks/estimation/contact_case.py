"""Case contact: figures of estimated contact transitions."""

from __future__ import annotations

import numpy as np
from surefoot import Robot

from estimation.calibration import calibration_error
from estimation.contact_transitions import TransitionScore, score_transitions
from estimation.degraded_foot_sensors import CONDITIONS, apply_condition, normal_forces
from estimation.log_rows import Log
from estimation.metrics import Result, Values
from estimation.recording import sample_rate
from estimation.replay import replay


def contact(robot: Robot, logs: dict[str, Log], seed: int) -> Result:
    """Evaluate delays, missed and false transitions of all logs under every sensor condition."""
    values: Values = {"fell": sum(float(log["fell"]) for log in logs.values())}
    for run, log in logs.items():
        for condition in CONDITIONS:
            total = score_log(robot, apply_condition(condition, log, seed))
            values.update(_values(total, f"{run}, {condition}"))
    return Result(values)


def score_log(robot: Robot, log: Log) -> TransitionScore:
    """Return the joint score of all feet."""
    estimates = replay(robot, log)
    share, rate = normal_forces(log) / log["weight"], sample_rate(log)
    total = TransitionScore([], 0, np.zeros((0, 2)))
    for foot in range(4):
        total += score_transitions(share[:, foot], estimates.contact[:, foot], rate)
    return total


def _values(total: TransitionScore, where: str) -> Values:
    delays = 1000.0 * np.array(total.delays)
    found = delays[np.isfinite(delays)]
    return {
        f"transitions: {where}": float(len(delays)),
        f"missed: {where}": float(np.sum(np.isinf(delays))),
        f"false: {where}": float(total.false),
        f"delay max: {where}": float(found.max()) if len(found) else np.nan,
        f"delay p95: {where}": float(np.percentile(found, 95)) if len(found) else np.nan,
        f"calibration error: {where}": calibration_error(total.calibration),
    }
