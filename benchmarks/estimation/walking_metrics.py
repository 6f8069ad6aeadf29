"""Metrics of the case walking: limits by figure and scenario."""

from __future__ import annotations

from surefoot.estimate.baselines import LEG_ODOMETRY, LINEAR_FILTER

from estimation.metric import Metric

BASELINE_NAMES = {LINEAR_FILTER: "linear filter", LEG_ODOMETRY: "leg odometry"}
# Scenarios on level ground, where a filter that assumes feet at height 0 has no height drift.
LEVEL = ("square05", "square09", "walk05", "walk10", "sideways", "rigid_soles", "ice")
# [m/s] Limits of the velocity error by scenario.
_VELOCITY = {"walk05": 0.015, "square05": 0.015, "walk10": 0.025, "square09": 0.025}
_VELOCITY |= {"rigid_soles": 0.006}
# [%] Limits of the end error and the height drift by scenario.
_CLOSURE = {"square05": 0.3, "square09": 1.0}
# [ms] Limits of the delays of edges by the condition of the foot sensors.
_DELAY = {"est": 10.0, "dead": 10.0, "raw without torques": 25.0}


def compared_figures(scenario: str) -> tuple[str, ...]:
    """Return the figures in which the estimator is compared with the baselines."""
    figures = ("velocity RMSE x", "velocity RMSE y", "velocity RMSE z", "tilt RMS", "end error")
    drift = () if scenario in LEVEL else ("height drift",)
    return (*figures, "yaw error", "relative error", *drift)


def _by_scenario() -> dict[str, Metric]:
    metrics = {}
    for name, limit in _VELOCITY.items():
        for axis in "xyz":
            metrics[f"velocity RMSE {axis}: {name}"] = Metric("m/s", limit)
    for name, limit in _CLOSURE.items():
        metrics[f"end error: {name}"] = Metric("% of the path", limit)
        metrics[f"height drift: {name}"] = Metric("% of the path", limit)
        metrics[f"yaw error: {name}"] = Metric("deg", 1.0)
    for name in (*LEVEL, "slope", "blocks"):
        metrics[f"tilt RMS: {name}"] = Metric("deg", 0.4, merged="rms")
        metrics[f"relative error: {name}"] = Metric("% of the path", 0.5)
        metrics[f"relative error: {name}, radius off"] = Metric("% of the path", 1.2)
        for figure in ("tilt", "velocity", "position", "yaw"):
            metrics[f"NEES {figure}: {name}"] = Metric("per dof", 2.0, 0.5, merged="mean")
        for condition, delay in _DELAY.items():
            metrics[f"touchdown p95: {name}, {condition}"] = Metric("ms", delay)
            metrics[f"lift-off p95: {name}, {condition}"] = Metric("ms", delay)
    return metrics


WALKING_METRICS: dict[str, Metric] = {
    **{f"walking/{name}": metric for name, metric in _by_scenario().items()},
    **{f"velocity RMSE {axis}": Metric("m/s") for axis in "xyz"},
    "tilt RMS": Metric("deg", merged="rms"),
    "end error": Metric("% of the path"),
    "height drift": Metric("% of the path"),
    "yaw error": Metric("deg"),
    "relative error": Metric("% of the path"),
    "missed edges": Metric("% of edges", upper_limit=0, merged="mean"),
    "extra edges": Metric("% of edges", upper_limit=1, merged="mean"),
    "median of ratio": Metric("ours / best baseline", upper_limit=1, merged="median"),
    "largest ratio": Metric("ours / best baseline", upper_limit=1.2, merged="max"),
}
"""Metrics by "case/figure" or by the figure's name up to its colon."""
