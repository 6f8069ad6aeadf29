"""Joint angles and velocities: in radians, within the robot's reach, of one sign."""

from __future__ import annotations

import itertools

import numpy as np

from surefoot._core import Error, Robot
from surefoot.estimate.checks.windows import DEG_PER_RAD, Windows, finite_median
from surefoot.geometry.batch_rotations import Array
from surefoot.messages.low_state_layout import LEGS
from surefoot.sensor_log.columns import MOTOR_NAMES
from surefoot.sensor_log.sensor_log import SensorLog

MAX_BEYOND_LIMIT = 0.5  # [rad] beyond a limit: no joint gets there, whatever its calibration
DEGREES_MARGIN = 0.2  # [rad] beyond a limit for degrees that are taken as such
ORDER_FIT_RATIO = 0.2  # of the squared error: another order explains the rest
MIN_ORDER_ERROR = 0.05  # of the squared motion: more than noise and a coarse rate make
MAX_STILL_DRIFT = (
    0.02  # [rad] RMS that noise of velocities adds up to at most; 0.001 where it is 0.05 rad/s
)
MIN_MOTION = 0.01  # [rad] RMS in windows where joints move


def check_angles(robot: Robot, log: SensorLog) -> list[str]:
    """Compare the median of each joint's angle with its limits; raises Error."""
    median = finite_median(log.columns["q"])
    lower, upper = robot.config.q_lower, robot.config.q_upper
    beyond = np.maximum(lower - median, median - upper)
    worst = int(np.argmax(beyond))
    if beyond[worst] <= MAX_BEYOND_LIMIT:
        return []
    radians = median / DEG_PER_RAD
    inside = np.all((radians > lower - DEGREES_MARGIN) & (radians < upper + DEGREES_MARGIN))
    if inside and np.abs(median).max() > 6.0:
        raise Error(
            f"{log.source}: column 'q': got a median of {median[worst]:.1f} for "
            f"{MOTOR_NAMES[worst]}, expected radians: all twelve are within the limits of "
            f"{robot.name} in degrees"
        )
    raise Error(
        f"{log.source}: column 'q_{worst}' ({MOTOR_NAMES[worst]}): got a median of "
        f"{median[worst]:.3f} rad, expected {lower[worst]:.2f} .. {upper[worst]:.2f} as "
        f"{robot.name} has it: order FR FL RR RL, each hip thigh calf, signs of the SDK"
    )


def check_velocities(log: SensorLog, windows: Windows) -> list[str]:
    """Compare dq with how q changes; raises Error."""
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
            f"{log.source}: column 'dq': got velocities of {slope:.2f} times the change of q, "
            "expected its sign"
        )
    if 0.5 * DEG_PER_RAD < slope < 2.0 * DEG_PER_RAD:
        raise Error(
            f"{log.source}: column 'dq': got velocities of {slope:.1f} times the change of q, "
            "expected rad/s: they seem to be in deg/s"
        )
    if not 0.5 < slope < 2.0:
        return [f"dq is {slope:.2f} times the change of q"]
    return []


def _warn_moving_while_still(moved: Array, integrated: Array) -> list[str]:
    """Return a doubt where joints that stand still, (w, 12) both, are said to move."""
    if len(moved) < 3:
        return []
    q_motion, dq_motion = (float(np.sqrt(np.mean(angles**2))) for angles in (moved, integrated))
    if dq_motion < max(MAX_STILL_DRIFT, 5.0 * q_motion):
        return []
    return [
        f"dq moves joints by {dq_motion:.3f} rad at a time in which q moves them by {q_motion:.4f}: deg/s?"
    ]


def _check_velocity_leg_order(log: SensorLog, moved: Array, integrated: Array) -> None:
    """Raise Error where one leg's velocities (w, 4, 3) are another's change of angles, not its own.

    A body that moves moves its legs much alike: only an order that fits far better is believed.
    """
    squared_error = np.sum((moved[:, :, None] - integrated[:, None]) ** 2, axis=(0, 3))  # of, by
    orders = list(itertools.permutations(range(4)))
    cost = [float(squared_error[range(4), order].sum()) for order in orders]
    best = orders[int(np.argmin(cost))]
    if min(cost) < ORDER_FIT_RATIO * cost[0] and cost[0] > MIN_ORDER_ERROR * float(
        np.sum(moved**2)
    ):
        names = " ".join(LEGS[best.index(k)] for k in range(4))
        raise Error(
            f"{log.source}: columns 'q' and 'dq': got velocities that are the change of q with "
            f"legs in the order {names}, expected FR FL RR RL in both"
        )
