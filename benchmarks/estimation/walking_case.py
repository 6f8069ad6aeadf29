"""Case walking: figures of the estimator and of the baselines on logs of a walking robot."""

from __future__ import annotations

import numpy as np
from surefoot import Robot
from surefoot.estimate.baselines import (
    LEG_ODOMETRY,
    LINEAR_FILTER,
    BaselineInputs,
    BaseMotion,
    run_baselines,
)

from estimation.contact_edges import EdgeScore, score_edges
from estimation.errors import matrices
from estimation.log_rows import Log
from estimation.metrics import Result, Values
from estimation.motion_errors import WALK_START, motion_values
from estimation.replay import Estimates, replay
from estimation.walking_consistency import consistency_values
from estimation.walking_foot_sensors import WALKING_CONDITIONS, walking_condition
from estimation.walking_metrics import BASELINE_NAMES, compared_figures

RADIUS_ERROR = 0.1  # relative error of the radius of the feet in the second replay


def walking(robot: Robot, logs: dict[str, Log], seed: int) -> Result:
    """Evaluate all figures of every log; a name ends with the scenario and what is special."""
    values: Values = {"fell": sum(float(log["fell"]) for log in logs.values())}
    scaled = 1.0 + RADIUS_ERROR * (1.0 if seed % 2 else -1.0)
    for name, log in logs.items():
        estimates = replay(robot, log, keep_covariance=True)
        motion = base_motion(estimates)
        ours = motion_values(log, motion)
        values.update(_named(ours, name))
        values.update(_named(consistency_values(log, estimates, motion), name))
        values.update(_baseline_values(robot, log, name, ours, estimates))
        wrong = base_motion(replay(with_foot_radius(robot, scaled), log))
        relative = motion_values(log, wrong)["relative error"]
        values[f"relative error: {name}, radius off"] = relative
        for condition in WALKING_CONDITIONS:
            contact = replay(robot, walking_condition(condition, log, seed)).contact
            score = score_edges(log, contact, WALK_START)
            values.update(_named(edge_values(score), f"{name}, {condition}"))
    return Result(values)


def base_motion(estimates: Estimates) -> BaseMotion:
    """Return the motion of the base that the estimator gives."""
    rotation = matrices(estimates.q[:, [6, 3, 4, 5]])
    velocity = np.einsum("nij,nj->ni", rotation, estimates.v[:, :3])
    return BaseMotion(rotation, estimates.q[:, :3], velocity)


def with_foot_radius(robot: Robot, scale: float) -> Robot:
    """Return the robot with the radius of its feet multiplied by `scale`."""
    config = robot.config
    config.foot_radius *= scale
    return Robot.from_serialized_model(robot.serialized_model(), config)


def edge_values(score: EdgeScore) -> Values:
    """Return missed and extra edges [%] and the 95th percentile of early and late edges [ms]."""
    values = {
        "missed edges": 100.0 * score.missed / max(score.true, 1),
        "extra edges": 100.0 * score.extra / max(score.true, 1),
    }
    for name, delays in (("touchdown", score.touchdown), ("lift-off", score.liftoff)):
        size = 1000.0 * np.abs(delays)
        values[f"{name} p95"] = float(np.percentile(size, 95)) if delays else np.nan
    return values


def _baseline_values(
    robot: Robot, log: Log, name: str, ours: Values, estimates: Estimates
) -> Values:
    time = (log["tick"] - log["tick"][0]) / 1000.0
    sensors = [log[key].astype(float) for key in ("gyroscope", "accelerometer", "q", "dq")]
    inputs = BaselineInputs.from_imu(robot, time, *sensors, estimates.contact > 0.5)
    motions = run_baselines(inputs)
    theirs = {key: motion_values(log, motions[key]) for key in (LINEAR_FILTER, LEG_ODOMETRY)}
    values: Values = {}
    for key, figures in theirs.items():
        values.update(_named(figures, f"{name}, {BASELINE_NAMES[key]}"))
    for figure in compared_figures(name):
        best = min(figures[figure] for figures in theirs.values())
        ratio = ours[figure] / best
        values[f"median of ratio: {name}, {figure}"] = ratio
        values[f"largest ratio: {name}, {figure}"] = ratio
    return values


def _named(values: Values, where: str) -> Values:
    return {f"{figure}: {where}": value for figure, value in values.items()}
