"""Cost of a walk: one number for how well a robot followed its commands and recovered from pushes.

Terms, objectives and falls are as in cost.py. The figures are those of `surefoot walk`.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from surefoot.tune.cost import Cost, objective_weights, weighted_cost
from surefoot.walk import WalkLog, summarise
from surefoot.walk.push_recovery import recovery_times

# The weights are chosen by hand, not measured: an objective weights most what its name says.
WALK_OBJECTIVES: dict[str, dict[str, float]] = {
    "walk": {
        **{"tracking": 1.0, "drift": 0.5, "tilt": 1.0, "slip": 0.5, "saturation": 0.1},
        **{"recovery": 1.0, "touchdown": 0.3, "stop": 0.3, "buzz": 0.3, "transport": 0.3},
    },
    "pushes": {
        **{"tracking": 0.3, "drift": 0.2, "tilt": 0.3, "slip": 0.2, "saturation": 0.05},
        **{"recovery": 3.0, "touchdown": 0.1, "stop": 0.2, "buzz": 0.1, "transport": 0.1},
    },
    "transport": {
        **{"tracking": 0.3, "drift": 0.3, "tilt": 0.3, "slip": 0.2, "saturation": 0.05},
        **{"recovery": 0.3, "touchdown": 0.2, "stop": 0.2, "buzz": 0.2, "transport": 3.0},
    },
}
"""Weight of each term in each objective of a walk."""

# A velocity error of 1 counts as 0.05 m/s or 0.1 rad/s RMS, and 0.02 m/s or rad/s in the mean.
_RMSE, _MEAN_ERROR = np.array([0.05, 0.05, 0.10]), np.array([0.02, 0.02, 0.02])

WALK_TERMS = {
    "tracking": "RMS error of vx, vy, yaw rate / 0.05 m/s, 0.05 m/s, 0.1 rad/s; mean of commands",
    "drift": "mean error of vx, vy, yaw rate / 0.02 m/s, 0.02 m/s, 0.02 rad/s; mean of commands",
    "tilt": "RMS of roll and pitch / 1 deg; mean of commands",
    "slip": "path of a loaded foot's contact point per step / 5 mm",
    "saturation": "share of ticks with a saturated motor / 1 %",
    "recovery": "mean time from the end of a push until the robot has recovered / 0.5 s",
    "touchdown": "largest normal force of a foot after a touchdown / 2 m g",
    "stop": "at the end: displacement of a foot in the stance / 20 mm; 2 more if it does not stand",
    "buzz": "RMS torque above 30 Hz of the worst motor / 5 % of its limit; mean of commands",
    "transport": "cost of transport / 0.5; mean of commands",
}
"""Definition of each term of a walk, as a quantity / the value of this quantity that gives 1."""


def walk_cost(log: WalkLog, objective: str) -> Cost:
    """Compute the cost of a walk; raise Error if the objective is unknown."""
    weights = objective_weights(objective, WALK_OBJECTIVES)
    return weighted_cost(_walk_terms(log), weights, log.fell, len(log) / log.settings.ticks)


def _walk_terms(log: WalkLog) -> dict[str, float]:
    summary = summarise(log)
    commands = [entry for entry in summary["commands"] if entry["velocity_rmse"] is not None]
    tau_max = float(np.max(log.robot.config.tau_max))
    times = recovery_times(log)
    return {
        "tracking": _mean(commands, "velocity_rmse", _RMSE),
        "drift": _mean(commands, "velocity_mean_error", _MEAN_ERROR),
        "tilt": _mean(commands, "roll_pitch_rms_deg", np.ones(2)),
        "slip": (summary["slip_mm_per_step"] or 0.0) / 5.0,
        "saturation": summary["saturated_ticks"] / len(log) / 0.01,
        "recovery": float(np.mean(times)) / 0.5 if times else 0.0,
        "touchdown": (summary["touchdown_force_mg"] or 0.0) / 2.0,
        "stop": summary["stance_error_mm"] / 20.0 + (0.0 if summary["stands_at_end"] else 2.0),
        "buzz": _mean(commands, "torque_hf_rms", np.array([0.05 * tau_max])),
        "transport": _mean(commands, "cost_of_transport", np.array([0.5])),
    }


def _mean(commands: list[dict[str, Any]], name: str, unit: np.ndarray) -> float:
    """Return the mean of a figure in a unit over its axes and all commands that have it."""
    values = [np.atleast_1d(entry[name]) / unit for entry in commands if entry[name] is not None]
    return float(np.mean(values)) if values else 0.0
