"""Does a log say what it claims to say?"""

from surefoot._core import Robot
from surefoot.estimate.sensor_log import SensorLog


def check_log(robot: Robot, log: SensorLog) -> list[str]:
    """Stub."""
    return []
