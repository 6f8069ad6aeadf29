"""What a bench is asked to be."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot._core import Error, Form
from surefoot.robot_files import RobotDescription
from surefoot.stand.settings import check_rate

LEAST_TICKS, MOST_TICKS = 100, 300_000
PUSH_SHARE = 0.5  # of what the linear inverted pendulum survives
PUSH_LENGTH = 0.1  # [s]


@dataclass(frozen=True)
class BenchSettings:
    """Robot, length and program of a bench.

    Attributes:
        robot: A name of surefoot.available_robots(), or what describe_robot() returns of files.
        ticks: Of the recorded run.
        form: Of the program that is timed.
        rate: Reports per second of the recorded run [Hz].
        seed: Of its sensors' noise.
    """

    robot: str | RobotDescription = "go1"
    ticks: int = 5000
    form: Form = Form.AUTO
    rate: float = 500.0
    seed: int = 1

    def __post_init__(self) -> None:
        if not LEAST_TICKS <= self.ticks <= MOST_TICKS:
            raise Error(f"ticks: got {self.ticks}, expected {LEAST_TICKS} to {MOST_TICKS}")
        check_rate(self.rate)
