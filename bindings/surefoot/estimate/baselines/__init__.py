"""Known estimators that run over a log beside surefoot.StateEstimator, for comparison.

The attitude is from VQF (package vqf). With this attitude, two estimators compute position and
velocity: a linear Kalman filter as in MIT's Cheetah-Software, and leg odometry. Neither has a
contact detection of its own, so both receive the contacts of surefoot.StateEstimator.
"""

from __future__ import annotations

from surefoot.estimate.base_motion import BaseMotion
from surefoot.estimate.baselines.inputs import BaselineInputs
from surefoot.estimate.baselines.run import LEG_ODOMETRY, LINEAR_FILTER, run_baselines

__all__ = ["LEG_ODOMETRY", "LINEAR_FILTER", "BaseMotion", "BaselineInputs", "run_baselines"]
