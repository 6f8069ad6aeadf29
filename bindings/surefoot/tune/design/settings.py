"""Settings of a design, and their ranges."""

from __future__ import annotations

from dataclasses import dataclass, field

from surefoot._core import Error, Gains
from surefoot.robot.description import RobotDescription
from surefoot.tune.design.directions import AXES
from surefoot.tune.design.goals import FREQUENCY_RANGE, Goal
from surefoot.tune.design.ranges import check_range
from surefoot.tune.design.timing import Timing, check_requested_delay

# Gains that are divided by trust_imu and trust_legs.
IMU_NOISE_GAINS = ("noise_gyroscope", "noise_accelerometer", "push_time", "push_dead_band")
LEG_NOISE_GAINS = ("noise_foot_position", "noise_foot_slip", "noise_foot_motion")


@dataclass(frozen=True)
class DesignSettings:
    """Settings of a design.

    Attributes:
        robot: The robot's files.
        goals: Goals by axis (see AXES); axes without a goal keep the gains of `start`.
        timing: Rate, additional delay and motor lag.
        start: Gains that the design changes. None: the robot's own gains.
        trust_imu: Number that divides the noise gains of gyroscope and accelerometer, and the time
            and dead band of the push observer.
        trust_legs: Number that divides the noise gains of stance feet.
        joint_friction_scale: Factor on the joint friction of the model.
    """

    robot: RobotDescription
    goals: dict[str, Goal]
    timing: Timing = field(default_factory=Timing)
    start: Gains | None = None
    trust_imu: float = 1.0
    trust_legs: float = 1.0
    joint_friction_scale: float = 1.0

    def check(self) -> None:
        """Raise Error for an unknown axis, or a number out of its range."""
        for name, goal in self.goals.items():
            if name not in AXES:
                raise Error(f"axis: got '{name}', expected one of {', '.join(AXES)}")
            check_range(f"{name}, frequency", goal.frequency, *FREQUENCY_RANGE, "Hz")
        check_requested_delay(self.timing.rate, self.timing.delay)
        # Chosen: noise gains of sensors that are ten times better or worse.
        check_range("trust_imu", self.trust_imu, 0.1, 10.0)
        check_range("trust_legs", self.trust_legs, 0.1, 10.0)
