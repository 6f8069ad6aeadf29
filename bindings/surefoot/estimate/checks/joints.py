"""Checks of joint angles and velocities: unit, joint limits, order and sign."""

from __future__ import annotations

import itertools

import numpy as np

from surefoot._core import Error, Robot
from surefoot.estimate.checks.windows import DEG_PER_RAD, Windows, finite_median
from surefoot.geometry.batch_rotations import Array
from surefoot.messages.low_state_layout import LEGS
from surefoot.sensor_log.column_definitions import MOTOR_NAMES
from surefoot.sensor_log.sensor_log import SensorLog

# Chosen limits; tests/python/test_sensor_log.py and test_estimate.py have wrong and right logs.
MAX_BEYOND_LIMIT = 0.5  # [rad] distance beyond a joint limit above which an angle is wrong
DEGREES_MARGIN = 0.2  # [rad] distance beyond a joint limit up to which an angle in degrees fits
# Ratio of squared errors, best order of legs to logged order, below which the best order is right.
# Chosen: above the ratio that noise leaves, and below 1, at which both orders fit equally well.
ORDER_FIT_RATIO = 0.2
# Ratio of the squared error of the logged order to the squared motion, below which the logged order
# is right. Chosen.
MIN_ORDER_ERROR = 0.05
# [rad] RMS of integrated dq per window at rest, above which dq is doubtful. Chosen: 20 times the
# 0.001 rad of good sensors; velocities in deg/s would give 57 times as much.
MAX_STILL_DRIFT = 0.02
# [rad] RMS change of q per window above which joints move. Chosen: ten times the 0.001 rad that
# velocity noise gives in a window.
MIN_MOTION = 0.01


def check_angles(robot: Robot, log: SensorLog) -> list[str]:
    """Compare the median of each joint angle with its limits; return warnings.

    Raises:
        Error: A median is far outside its limits.
    """
    median = finite_median(log.columns["q"])
    lower, upper = robot.config.q_lower, robot.config.q_upper
    beyond = np.maximum(lower - median, median - upper)
    worst = int(np.argmax(beyond))
    if beyond[worst] <= MAX_BEYOND_LIMIT:
        return []
    radians = median / DEG_PER_RAD
    inside = np.all((radians > lower - DEGREES_MARGIN) & (radians < upper + DEGREES_MARGIN))
    # Angles up to 6 rad, about one turn, may be radians with a wrong zero.
    if inside and np.abs(median).max() > 6.0:
        raise Error(
            f"{log.source}: column 'q': got a median of {median[worst]:.1f} for "
            f"{MOTOR_NAMES[worst]}, expected radians: all twelve are within the "
            f"limits of {robot.name} if read as values in degrees"
        )
    raise Error(
        f"{log.source}: column 'q_{worst}' ({MOTOR_NAMES[worst]}): got a median of "
        f"{median[worst]:.3f} rad, expected {lower[worst]:.2f} .. {upper[worst]:.2f}, the "
        f"limits of {robot.name}: order FR FL RR RL, each hip thigh calf, signs of the SDK"
    )


def check_velocities(log: SensorLog, windows: Windows) -> list[str]:
    """Compare the integral of dq with the change of q; return warnings.

    Raises:
        Error: dq has a wrong unit, sign or order of legs.
    """
    if "dq" not in log.columns or len(windows) == 0:
        return []
    moving = np.sqrt(np.mean(windows.q_change**2, axis=1)) > MIN_MOTION
    if moving.sum() < 3:
        return _warn_moving_while_still(windows.q_change[~moving], windows.dq_integral[~moving])
    moved, integrated = windows.q_change[moving], windows.dq_integral[moving]
    _check_velocity_leg_order(log, moved.reshape(-1, 4, 3), integrated.reshape(-1, 4, 3))
    slope = float(np.sum(moved * integrated) / np.sum(moved**2))
    if slope < -0.5:
        raise Error(
            f"{log.source}: column 'dq': got velocities {slope:.2f} times the change of q, "
            "expected the same sign"
        )
    if 0.5 * DEG_PER_RAD < slope < 2.0 * DEG_PER_RAD:
        raise Error(
            f"{log.source}: column 'dq': got velocities {slope:.1f} times the change of q, "
            "expected rad/s: they seem to be in deg/s"
        )
    if not 0.5 < slope < 2.0:
        return [f"dq is {slope:.2f} times the change of q"]
    return []


def _warn_moving_while_still(moved: Array, integrated: Array) -> list[str]:
    """Return a warning if joints are at rest in q but move in dq.

    Args:
        moved: (w, 12) change of q in each window [rad].
        integrated: (w, 12) integral of dq over each window [rad].
    """
    if len(moved) < 3:
        return []
    q_motion, dq_motion = (float(np.sqrt(np.mean(angles**2))) for angles in (moved, integrated))
    # Chosen: five times is far more than noise, and far less than 57, the ratio of deg/s to rad/s.
    if dq_motion < max(MAX_STILL_DRIFT, 5.0 * q_motion):
        return []
    return [
        f"dq moves joints by {dq_motion:.3f} rad per window and q by {q_motion:.4f}: "
        "is dq in deg/s?"
    ]


def _check_velocity_leg_order(log: SensorLog, moved: Array, integrated: Array) -> None:
    """Raise Error if the velocities of a leg match the angles of another leg.

    When the base moves, all legs move almost alike. So only another order that fits far better is
    an error. `moved` and `integrated` are (w, 4, 3) [rad].
    """
    squared_error = np.sum(
        (moved[:, :, None] - integrated[:, None]) ** 2, axis=(0, 3)
    )  # [leg of q, leg of dq]
    orders = list(itertools.permutations(range(4)))
    cost = [float(squared_error[range(4), order].sum()) for order in orders]
    best = orders[int(np.argmin(cost))]
    if min(cost) < ORDER_FIT_RATIO * cost[0] and cost[0] > MIN_ORDER_ERROR * float(
        np.sum(moved**2)
    ):
        names = " ".join(LEGS[best.index(k)] for k in range(4))
        raise Error(
            f"{log.source}: columns 'q' and 'dq': got velocities that match q with the legs in "
            f"the order {names}, expected FR FL RR RL in both"
        )
