"""Errors of an estimate against the ground truth of its log."""

from __future__ import annotations

from typing import Any

import numpy as np

from surefoot.estimate.contact_events import Transition, transitions
from surefoot.estimate.estimate_result import Estimate
from surefoot.geometry.batch_rotations import Array, matrices_from_xyzw, rpy_from_matrices
from surefoot.messages.low_state_layout import LEGS

GRAVITY = 9.81
# [s] Smallest and largest delay from a true transition to an estimated transition that matches.
# Chosen: the estimate precedes the truth by less than 0.1 s for a foot that is unloaded slowly, and
# the slowest detection takes less than 0.3 s.
MATCH_BEFORE, MATCH_AFTER = -0.1, 0.3
# [N] Force above which a foot is loaded, in a log without truth_contact. Chosen: larger than the
# rounding errors of a simulation, far smaller than the weight of a foot.
MIN_CONTACT_FORCE = 1.0


def truth_summary(estimate: Estimate) -> dict[str, Any]:
    """Return the fields of the group Truth; a field is None if the log lacks its truth column."""
    return {
        "velocity_rmse": _velocity_rmse(estimate),
        "roll_pitch_rmse_deg": _tilt_rmse(estimate),
        "height_error_range": _height_range(estimate),
        "vertical_force_rmse": _force_rmse(estimate),
        "contact_delays": _delays(estimate),
    }


def true_rows(estimate: Estimate, name: str) -> Array | None:
    """Return a truth column at the estimate's rows (m, k); NaN before the first accepted row.

    None: the log lacks the column.
    """
    if name not in estimate.log.columns:
        return None
    values = estimate.log.columns[name][estimate.rows].copy()
    values[~estimate.valid] = np.nan
    return values


def true_rpy(estimate: Estimate) -> Array | None:
    """Return the true roll, pitch, yaw (m, 3) [rad]; None if the log has no true attitude."""
    wxyz = true_rows(estimate, "truth_quaternion")
    return None if wxyz is None else rpy_from_matrices(matrices_from_xyzw(wxyz[:, [1, 2, 3, 0]]))


def heading_offset(estimate: Estimate) -> float:
    """Return the yaw [rad] of the estimator's world axes in the true world axes.

    0: the log has no true attitude.
    """
    rpy = true_rpy(estimate)
    if rpy is None or not np.isfinite(rpy).any():
        return 0.0
    first = np.flatnonzero(np.isfinite(rpy).all(axis=1))[0]
    return float(rpy[first, 2] - estimate.rpy[first, 2])


def rotate_by_yaw(values: Array, yaw: float) -> Array:
    """Rotate vectors (n, 3) about world z by `yaw` [rad]."""
    c, s = np.cos(yaw), np.sin(yaw)
    return np.asarray(values @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]]))


def _rms(errors: Array, axis: int | None = None) -> Any:
    return np.sqrt(np.nanmean(errors**2, axis=axis)) if np.isfinite(errors).any() else None


def _velocity_rmse(estimate: Estimate) -> float | None:
    truth = true_rows(estimate, "truth_v")
    if truth is None:
        return None
    error = rotate_by_yaw(estimate.v_world, heading_offset(estimate)) - truth
    length: float | None = _rms(np.linalg.norm(error, axis=1))
    return length


def _tilt_rmse(estimate: Estimate) -> Any:
    truth = true_rpy(estimate)
    if truth is None:
        return None
    error = np.degrees((estimate.rpy - truth)[:, :2])
    return _rms((error + 180.0) % 360.0 - 180.0, axis=0)


def _height_range(estimate: Estimate) -> list[float] | None:
    truth = true_rows(estimate, "truth_p")
    if truth is None:
        return None
    error = estimate.q[:, 2] - truth[:, 2]
    error = error[np.isfinite(error)]
    return [(error - error[0]).min(), (error - error[0]).max()] if len(error) else None


def _force_rmse(estimate: Estimate) -> dict[str, Any] | None:
    truth = true_rows(estimate, "truth_foot_forces")
    if truth is None:
        return None
    share = (estimate.foot_forces_from_torques - truth[:, 2::3]) / (estimate.robot.mass * GRAVITY)
    return {leg: _rms(share[:, k]) for k, leg in enumerate(LEGS)}


def true_contact(estimate: Estimate) -> Array | None:
    """Return the true contact (m, 4): 1 for a foot on the ground, 0 for one off the ground.

    NaN: before the first accepted row. None: the log has neither truth_contact nor
    truth_foot_forces.
    """
    standing = true_rows(estimate, "truth_contact")
    forces = true_rows(estimate, "truth_foot_forces")
    if standing is None and forces is not None:
        load = np.linalg.norm(forces.reshape(-1, 4, 3), axis=2)
        standing = np.where(np.isfinite(load), load > MIN_CONTACT_FORCE, np.nan)
    return standing


def _delays(estimate: Estimate) -> dict[str, Any] | None:
    standing = true_contact(estimate)
    if standing is None:
        return None
    true, estimated = (
        transitions(estimate.time, standing),
        transitions(estimate.time, estimate.contact),
    )
    return {leg: _match_transitions(true, estimated, k) for k, leg in enumerate(LEGS)}


def _match_transitions(
    true: list[Transition], estimated: list[Transition], leg: int
) -> dict[str, Any]:
    """Match each true transition with the nearest estimated one; return counts and delays."""
    unmatched = [change for change in estimated if change.leg == leg]
    delays = []
    true_transitions = [change for change in true if change.leg == leg]
    for change in true_transitions:
        candidates = [
            other
            for other in unmatched
            if other.begins == change.begins
            and MATCH_BEFORE <= other.time - change.time <= MATCH_AFTER
        ]
        if candidates:
            best = min(candidates, key=lambda other: abs(other.time - change.time))
            unmatched.remove(best)
            delays.append(best.time - change.time)
    return {
        "true": len(true_transitions),
        "missed": len(true_transitions) - len(delays),
        "false": len(unmatched),
        "mean_s": float(np.mean(delays)) if delays else None,
        "max_s": max(delays) if delays else None,
    }
