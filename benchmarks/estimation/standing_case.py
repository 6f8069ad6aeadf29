"""Cases quiet, quiet_long and push60: figures of quiet standing and of pushes."""

from __future__ import annotations

import numpy as np
from surefoot import Robot

from estimation.contact_transitions import score_transitions
from estimation.degraded_foot_sensors import CONDITIONS, apply_condition, normal_forces
from estimation.errors import compute_errors, rms
from estimation.log_rows import Log
from estimation.metrics import Result, Values
from estimation.recording import sample_rate
from estimation.replay import Estimates, replay
from estimation.row_selection import SETTLING_TIME, rows_after

Logs = dict[str, Log]


def quiet(robot: Robot, logs: Logs, seed: int) -> Result:
    """Evaluate the drift in a minute, and false transitions under every sensor condition."""
    return _quiet_result(robot, logs["quiet"], seed)


def quiet_long(robot: Robot, logs: Logs, seed: int) -> Result:
    """Evaluate the same figures over ten minutes."""
    return _quiet_result(robot, logs["quiet_long"], seed)


def _quiet_result(robot: Robot, log: Log, seed: int) -> Result:
    values = _drift_values(robot, log)
    for condition in CONDITIONS:
        estimates = replay(robot, apply_condition(condition, log, seed))
        values[f"false: {condition}"] = false_transitions(log, estimates)
    return Result(values)


def _drift_values(robot: Robot, log: Log) -> Values:
    estimates = replay(robot, log)
    height = compute_errors(log, estimates).height[rows_after(log, SETTLING_TIME)]
    return {
        "fell": float(log["fell"]),
        "height drift": 1000.0 * float(np.abs(height - height[0]).max()),
        "false: recorded": false_transitions(log, estimates),
    }


def false_transitions(log: Log, estimates: Estimates) -> float:
    """Return the number of estimated transitions of all feet that match no true transition."""
    share, rate = normal_forces(log) / log["weight"], sample_rate(log)
    scores = [score_transitions(share[:, k], estimates.contact[:, k], rate) for k in range(4)]
    return float(sum(one.false for one in scores))


def push60(robot: Robot, logs: Logs, seed: int) -> Result:
    """Evaluate the errors in pushes, and return the series for the consistency over seeds."""
    log = logs["push60"]
    estimates = replay(robot, log, keep_covariance=True)
    errors, rows = compute_errors(log, estimates), rows_after(log, SETTLING_TIME)
    velocity, tilt = errors.velocity[rows], np.degrees(errors.tilt[rows])
    # At rest a tilt of bias / g is not observable, so only the error beyond this tilt counts.
    indistinguishable_tilt = np.degrees(np.linalg.norm(errors.tilt_from_bias[rows], axis=1))
    excess_tilt = np.maximum(np.linalg.norm(tilt, axis=1) - indistinguishable_tilt, 0.0)
    has_forces = np.any(estimates.forces != 0.0)
    force = (estimates.forces[:, 2] - normal_forces(log))[rows] / log["weight"]
    per_foot = np.sqrt(np.mean(force**2, axis=0)) if has_forces else np.full(4, np.nan)
    values = {
        "fell": float(log["fell"]),
        "velocity RMSE": rms(np.linalg.norm(velocity, axis=1)),
        "velocity RMSE per axis": max(rms(velocity[:, k]) for k in range(3)),
        "tilt RMSE": max(rms(tilt[:, k]) for k in range(2)),
        "tilt RMSE beyond bias": rms(excess_tilt),
        "force RMSE": 100.0 * float(per_foot.max()),
    }
    dof = estimates.nis_dimension
    nees = errors.nees[rows]
    series = {
        "NIS": estimates.nis[rows],
        "NIS dof": dof[rows],
        "NEES": nees,
        "NEES dof": np.where(np.isfinite(nees), 5, 0),
    }
    return Result(values, series)
