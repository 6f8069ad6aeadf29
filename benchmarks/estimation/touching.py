"""Figures of contacts that open and close."""

from __future__ import annotations

import numpy as np
from surefoot import Robot

from estimation.calibration import calibration_error
from estimation.contacts import Score, score
from estimation.figures import Result, Values
from estimation.log_rows import Log
from estimation.recording import rate_of
from estimation.replay import replay
from estimation.sensors import CONDITIONS, normal_forces, under


def contact(robot: Robot, logs: dict[str, Log], seed: int) -> Result:
    """Delays, missed and false transitions of lifts and of lifted feet under every condition."""
    values: Values = {"fell": sum(float(log["fell"]) for log in logs.values())}
    for run, log in logs.items():
        for condition in CONDITIONS:
            total = score_log(robot, under(condition, log, seed))
            values.update(_values(total, f"{run}, {condition}"))
    return Result(values)


def score_log(robot: Robot, log: Log) -> Score:
    """Return the score of all feet together."""
    estimates = replay(robot, log)
    share, rate = normal_forces(log) / log["weight"], rate_of(log)
    total = Score([], 0, np.zeros((0, 2)))
    for foot in range(4):
        total += score(share[:, foot], estimates.contact[:, foot], rate)
    return total


def _values(total: Score, where: str) -> Values:
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
