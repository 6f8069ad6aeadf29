"""Checks of the order of the legs (FR FL RR RL) and of the signs of the hips, by foot positions.

Each foot must be in its own quadrant of the base. The distances between stance feet must also stay
constant while the base moves. The log is wrong if another order of legs, or mirrored hips, keep
these distances far better.
"""

from __future__ import annotations

import itertools

import numpy as np

from surefoot._core import Error, Robot
from surefoot.estimate.checks.torques import feet_are_loaded
from surefoot.estimate.checks.windows import Windows, finite_median
from surefoot.estimate.foot_placements import foot_placements
from surefoot.geometry.batch_rotations import Array, matrices_from_xyzw
from surefoot.messages.low_state_layout import LEGS
from surefoot.sensor_log.sensor_log import SensorLog

_QUADRANT_SIGNS = np.array([[1, -1], [1, 1], [-1, -1], [-1, 1]])  # of x and y; rows FR FL RR RL
_SIGN = {1: "> 0", -1: "< 0"}
_MIRRORED_LEGS = {"": [], "right hips": [0, 2], "left hips": [1, 3], "all hips": [0, 1, 2, 3]}
# Chosen.
SPAN_WINDOWS = 3  # number of windows in one comparison: 0.3 s
COMPARISONS = 12  # number of comparisons, at the times of the most joint motion
# [m] Slide in 0.3 s below which the logged order is right. Chosen: larger than rolling and noise of
# standing feet, smaller than the slide that a wrong order of legs gives.
MAX_FOOT_SLIDE = 0.0015
# Ratio of squared slides, best order to logged order, below which the best order is right. Chosen:
# smaller than in joints.py, because feet slip in right logs too.
ORDER_FIT_RATIO = 0.15


def check_quadrants(robot: Robot, log: SensorLog) -> None:
    """Check that each foot is in its own quadrant of the base.

    Raises:
        Error: The median of q puts a foot into the quadrant of another foot.
    """
    foot_positions = foot_placements(robot, finite_median(log.columns["q"])[None])[0][0]
    for leg, name in enumerate(LEGS):
        if np.any(foot_positions[leg, :2] * _QUADRANT_SIGNS[leg] <= 0.0):
            x, y = foot_positions[leg, :2]
            raise Error(
                f"{log.source}: column 'q': got foot {name} at x = {x:.3f} m, y = {y:.3f} m from "
                f"the base (median), expected x {_SIGN[_QUADRANT_SIGNS[leg, 0]]}, "
                f"y {_SIGN[_QUADRANT_SIGNS[leg, 1]]}: order FR FL RR RL, signs of the SDK"
            )


def check_stance(robot: Robot, log: SensorLog, windows: Windows) -> list[str]:
    """Find the order of legs and the hip signs that keep the distances between feet best.

    The robot must not walk: all feet are assumed to stand.

    Return a warning if the log has another order or other signs but the feet may not be loaded.

    Raises:
        Error: The log has another order or other signs, and the feet are loaded.
    """
    moved, turned = (_span_sums(values) for values in (windows.q_change, windows.gyro_rotation))
    most_moving = np.argsort(-np.linalg.norm(moved, axis=1))[:COMPARISONS]
    if len(most_moving) == 0:
        return []
    # Indices: window, start or end, hip sign, leg, leg that the angles belong to, xyz.
    rows = np.stack(
        [windows.start[most_moving], windows.end[most_moving + SPAN_WINDOWS - 1]], axis=1
    )
    table = _feet_with_exchanged_angles(robot, log.columns["q"][rows.ravel()])
    table = table.reshape(*rows.shape, *table.shape[1:])
    start_to_end = np.swapaxes(_base_rotations(robot, turned[most_moving]), 1, 2)
    slides = {}
    for flip, order in itertools.product(_MIRRORED_LEGS, itertools.permutations(range(4))):
        mirrored = np.isin(np.arange(4), _MIRRORED_LEGS[flip]).astype(int)
        placed = table[:, :, mirrored, np.arange(4), list(order), :]
        slides[flip, order] = _median_slide(placed, start_to_end)
    logged_slide = slides["", (0, 1, 2, 3)]
    flip, order = min(slides, key=lambda key: slides[key])
    if logged_slide < MAX_FOOT_SLIDE**2 or slides[flip, order] > ORDER_FIT_RATIO * logged_slide:
        return []
    names = " ".join(LEGS[list(order).index(k)] for k in range(4))
    found = f"legs in the order {names}" + (f" with {flip} mirrored" if flip else "")
    reversed_gyro_slide = _median_slide(
        table[:, :, 0, np.arange(4), np.arange(4)], np.swapaxes(start_to_end, 1, 2)
    )
    if reversed_gyro_slide < slides[flip, order]:
        found = "the gyroscope reversed"
    slid = f"feet that slide by {1000 * np.sqrt(logged_slide):.0f} mm in 0.3 s"
    if not feet_are_loaded(robot, log, rows.ravel()):
        return [f"q has {slid}, but stand still with {found}: is the order wrong, or do they hang?"]
    raise Error(
        f"{log.source}: columns 'q' and 'gyroscope': got {slid}, but stand still with {found}; "
        "expected FR FL RR RL, signs of the SDK"
    )


def _median_slide(placed: Array, start_to_end: Array) -> float:
    """Return the median over windows of the summed squared relative motion of the feet [m^2].

    Args:
        placed: (w, 2, 4, 3) feet in base axes at start and end [m].
        start_to_end: (w, 3, 3) rotations from base axes at the start to base axes at the end.
    """
    placed = placed - placed.mean(axis=2, keepdims=True)
    slide = placed[:, 1] - np.einsum("nij,nlj->nli", start_to_end, placed[:, 0])
    return float(np.median(np.sum(slide**2, axis=(1, 2))))


def _span_sums(values: Array) -> Array:
    """Return the sums (w - SPAN_WINDOWS + 1, k) of SPAN_WINDOWS consecutive rows of (w, k)."""
    total = np.cumsum(np.vstack([np.zeros_like(values[:1]), values]), axis=0)
    return np.asarray(total[SPAN_WINDOWS:] - total[:-SPAN_WINDOWS])


def _feet_with_exchanged_angles(robot: Robot, q: Array) -> Array:
    """Return the foot position of each leg for the angles of each leg, base axes [m].

    Args:
        robot: Robot model.
        q: (n, 12) joint angles [rad].

    Returns:
        (n, 2, 4, 4, 3): row, hip sign, leg, leg that the angles belong to, xyz.
    """
    angles = q.reshape(-1, 4, 3)
    table = np.zeros((len(q), 2, 4, 4, 3))
    for mirrored, shift in itertools.product(range(2), range(4)):
        source_leg = (np.arange(4) + shift) % 4
        turned = angles[:, source_leg] * ([-1.0, 1.0, 1.0] if mirrored else 1.0)
        centre = foot_placements(robot, turned.reshape(-1, 12))[0]
        table[:, mirrored, np.arange(4), source_leg] = centre
    return table


def _base_rotations(robot: Robot, turned: Array) -> Array:
    """Return the rotations (n, 3, 3) from base axes at the end to base axes at the start.

    `turned` (n, 3) is the rotation vector of the gyroscope, IMU axes [rad].
    """
    w, x, y, z = robot.config.quat_base_imu
    axes = turned @ matrices_from_xyzw(np.array([[x, y, z, w]]))[0].T
    angle = np.linalg.norm(axes, axis=1, keepdims=True)
    axis = axes / np.maximum(angle, 1e-12)
    return matrices_from_xyzw(np.hstack([np.sin(angle / 2) * axis, np.cos(angle / 2)]))
