"""What is asked of a design, and what may be."""

from __future__ import annotations

from dataclasses import dataclass, field

from surefoot._core import Error, Gains
from surefoot.robot.description import RobotDescription
from surefoot.tune.design.directions import AXES
from surefoot.tune.design.goals import FREQUENCY_RANGE, Goal
from surefoot.tune.design.ranges import check_range
from surefoot.tune.design.timing import Timing, check_requested_delay

# Trust in a sensor divides these of the robot's own gains.
IMU_NOISE_GAINS = ("noise_gyroscope", "noise_accelerometer", "push_time", "push_dead_band")
LEG_NOISE_GAINS = ("noise_foot_position", "noise_foot_slip", "noise_foot_motion")


@dataclass(frozen=True)
class DesignSettings:
    """What is asked for.

    Attributes:
        robot: Its files.
        goals: By axis (see AXES); an axis that is not there keeps the robot's own gains.
        timing: Rate, further delay, motor lag.
        start: Gains that all others are taken from; None is the robot's own.
        trust_imu: Divides the noise that is first assumed of gyroscope and accelerometer, and the
            push observer's time and dead band.
        trust_legs: Divides the noise that is first assumed of standing feet.
        joint_friction_scale: Factor on the joints' friction.
    """

    robot: RobotDescription
    goals: dict[str, Goal]
    timing: Timing = field(default_factory=Timing)
    start: Gains | None = None
    trust_imu: float = 1.0
    trust_legs: float = 1.0
    joint_friction_scale: float = 1.0

    def check(self) -> None:
        """Raise Error for an axis that is none, or a number that is out of its range."""
        for name, goal in self.goals.items():
            if name not in AXES:
                raise Error(f"axis: got '{name}', expected one of {', '.join(AXES)}")
            check_range(f"{name}, frequency", goal.frequency, *FREQUENCY_RANGE, "Hz")
        check_requested_delay(self.timing.rate, self.timing.delay)
        check_range("trust in the IMU", self.trust_imu, 0.1, 10.0)
        check_range("trust in the legs", self.trust_legs, 0.1, 10.0)
