"""Checks of units, orders and signs in a log.

The checks compare the sensors with each other and with the robot's geometry. An estimate from a
wrong log can look plausible, so a clear contradiction raises Error. A doubtful finding is a
warning.
"""

from __future__ import annotations

from surefoot._core import Robot
from surefoot.estimate.checks.imu import (
    check_accelerometer,
    check_gyroscope_rotation,
    check_gyroscope_unit,
)
from surefoot.estimate.checks.joints import check_angles, check_velocities
from surefoot.estimate.checks.leg_order import check_quadrants, check_stance
from surefoot.estimate.checks.quaternion import check_quaternion
from surefoot.estimate.checks.torques import check_torques
from surefoot.estimate.checks.walking.check import check_walk, find_walk
from surefoot.estimate.checks.windows import cut_windows
from surefoot.sensor_log.sensor_log import SensorLog

__all__ = ["check_log"]


def check_log(robot: Robot, log: SensorLog) -> list[str]:
    """Check a log of a robot; return a warning for each doubtful finding.

    Raises:
        Error: A column is wrong. The message names the column, the value and the expected value.
    """
    doubts = check_accelerometer(robot, log) + check_angles(robot, log)
    windows = cut_windows(log)
    doubts += check_velocities(log, windows)
    check_gyroscope_unit(log)
    walk = find_walk(robot, log)
    if walk is None:
        doubts += check_gyroscope_rotation(log, windows)
        doubts += check_quaternion(log, windows)
        check_quadrants(robot, log)
        doubts += check_stance(robot, log, windows)
    else:
        check_quadrants(robot, log)
        found = check_walk(walk)
        # With a fault of the gyroscope, the quaternion would look wrong.
        doubts += found or check_quaternion(log, windows)
    return [*doubts, *check_torques(robot, log)]
