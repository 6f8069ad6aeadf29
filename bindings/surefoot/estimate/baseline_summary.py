"""Comparison of the estimate with the baselines, in numbers."""

from __future__ import annotations

from typing import Any

import numpy as np

from surefoot.estimate.base_motion import BaseMotion
from surefoot.estimate.estimate_result import Estimate
from surefoot.estimate.truth_summary import true_rows, true_rpy
from surefoot.geometry.batch_rotations import Array, rotations_about_z, tilt_between

OWN_NAME = "surefoot"  # key of the estimator's own figures


def baseline_summary(estimate: Estimate) -> dict[str, Any] | None:
    """Return the figures of the estimator and of each baseline; None without baselines."""
    if not estimate.baselines:
        return None
    motions = {OWN_NAME: estimate.motion, **estimate.baselines}
    return {name: _figures(estimate, motion) for name, motion in motions.items()}


def _figures(estimate: Estimate, motion: BaseMotion) -> dict[str, Any]:
    valid = estimate.valid
    own, motion = estimate.motion.rows(valid), motion.rows(valid)
    moved = motion.position[-1] - motion.position[0]
    velocity = _in_heading(motion.velocity, motion.yaw)
    truth, true_angles = true_rows(estimate, "truth_v"), true_rpy(estimate)
    error = None
    if truth is not None and true_angles is not None:
        error = _rms_norm(velocity - _in_heading(truth[valid], true_angles[valid, 2]))
    tilt = np.degrees(tilt_between(motion.rotation, own.rotation))
    return {
        "closure": float(np.linalg.norm(moved[:2])),
        "height_drift": float(moved[2]),
        "yaw_deg": float(np.degrees(motion.yaw[-1] - motion.yaw[0])),
        "velocity_difference": _rms_norm(velocity - _in_heading(own.velocity, own.yaw)),
        "tilt_difference_deg": float(np.sqrt(np.mean(tilt**2))),
        "velocity_error": error,
    }


def _in_heading(velocity: Array, yaw: Array) -> Array:
    """Return velocities (n, 3) in axes that are turned by the yaw (n,) [rad] about z."""
    return np.asarray(np.einsum("nij,nj->ni", rotations_about_z(-yaw), velocity))


def _rms_norm(values: Array) -> float:
    """Return the root mean square of the norms of the finite rows (n, 3)."""
    squares = np.sum(values**2, axis=1)
    return float(np.sqrt(np.mean(squares[np.isfinite(squares)])))
