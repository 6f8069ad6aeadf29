"""Whether a log can be what it says it is: units, orders, signs, as its sensors tell each other.

What contradicts beyond doubt is refused, for an estimate of it would look like one; what is only
doubtful is a warning.
"""

from __future__ import annotations

from surefoot._core import Robot
from surefoot.estimate.checks.imu import check_accelerometer, check_gyroscope
from surefoot.estimate.checks.joints import check_angles, check_velocities
from surefoot.estimate.checks.leg_order import check_legs
from surefoot.estimate.checks.quaternion import check_quaternion
from surefoot.estimate.checks.torques import check_torques
from surefoot.estimate.checks.windows import cut_windows
from surefoot.sensor_log.sensor_log import SensorLog

__all__ = ["check_log"]


def check_log(robot: Robot, log: SensorLog) -> list[str]:
    """Return what is doubtful about a log of a robot.

    Raises:
        Error: What is wrong beyond doubt, naming the column, what was got and what expected.
    """
    doubts = check_accelerometer(robot, log) + check_angles(robot, log)
    windows = cut_windows(log)
    return [
        *doubts,
        *check_velocities(log, windows),
        *check_gyroscope(log, windows),
        *check_quaternion(log, windows),
        *check_torques(robot, log),
        *check_legs(robot, log, windows),
    ]
