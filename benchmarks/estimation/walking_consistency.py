"""Consistency while walking: normalised squared errors per degree of freedom."""

from __future__ import annotations

import numpy as np
from surefoot.estimate.baselines import BaseMotion

from estimation.errors import compute_errors
from estimation.log_rows import Array, Log
from estimation.metrics import Values
from estimation.motion_errors import relative_errors, true_motion, walking_rows
from estimation.recording import sample_rate
from estimation.replay import Estimates

YAW_TIME = 10.0  # [s] time over which the change of the yaw is compared
YAW, POSITION = 2, (6, 7)  # rows of the covariance: rotation about z, horizontal position


def consistency_values(log: Log, estimates: Estimates, motion: BaseMotion) -> Values:
    """Return the NEES of tilt, velocity, relative position over 2 m and yaw over 10 s."""
    errors, walk = compute_errors(log, estimates), walking_rows(log)
    error = np.concatenate([errors.tilt, errors.velocity], axis=1)[walk]
    P = errors.covariance[walk]
    return {
        "NEES tilt": _nees(error[:, :2], P[:, :2, :2]),
        "NEES velocity": _nees(error[:, 2:], P[:, 2:, 2:]),
        "NEES position": _position_nees(log, estimates.covariance, motion),
        "NEES yaw": _yaw_nees(log, estimates.covariance[:, YAW, YAW], motion),
    }


def _nees(error: Array, covariance: Array) -> float:
    solved = np.linalg.solve(covariance, error[:, :, None])[:, :, 0]
    return float(np.einsum("ni,ni->n", error, solved).mean() / error.shape[1])


def _position_nees(log: Log, covariance: Array, motion: BaseMotion) -> float:
    """Return the NEES of the horizontal relative position; NaN if the path is too short.

    With the yaw error psi at the start a, the error at the end b is the error at a, plus psi
    times the displacement turned by 90 deg, plus the relative error, which is independent of both.
    """
    squares, rows = [], [*POSITION, YAW]
    for a, b, error in relative_errors(log, motion):
        x, y, _ = motion.position[b] - motion.position[a]
        transition = np.array([[1.0, 0.0, -y], [0.0, 1.0, x]])
        P_a = covariance[a][np.ix_(rows, rows)].astype(float)
        P_b = covariance[b][np.ix_(POSITION, POSITION)].astype(float)
        P = P_b - transition @ P_a @ transition.T
        if np.linalg.eigvalsh(P)[0] <= 0.0:
            return np.inf
        squares.append(_turned_square(error[:2], P, motion, log, a))
    return float(np.mean(squares)) / 2.0 if squares else np.nan


def _turned_square(error: Array, P: Array, motion: BaseMotion, log: Log, a: int) -> float:
    """Return the normalised square of an error (2,) in true axes, with P in estimated axes."""
    angle = motion.yaw[a] - true_motion(log).yaw[a]
    c, s = np.cos(angle), np.sin(angle)
    turned = np.array([[c, -s], [s, c]]) @ error
    return float(turned @ np.linalg.solve(P, turned))


def _yaw_nees(log: Log, variance: Array, motion: BaseMotion) -> float:
    """Return the NEES of the change of the yaw; the variance of the change is the growth."""
    rows = round(YAW_TIME * sample_rate(log))
    error = motion.yaw - true_motion(log).yaw
    change, growth = error[rows:] - error[:-rows], variance[rows:] - variance[:-rows]
    if len(change) == 0 or growth.min() <= 0.0:
        return np.nan if len(change) == 0 else np.inf
    return float(np.mean(change**2 / growth))
