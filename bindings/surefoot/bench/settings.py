"""What a bench is asked to be."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot._core import Error, Form
from surefoot.bench.problems import SCENARIOS
from surefoot.robot_files import RobotDescription
from surefoot.stand.settings import check_rate

TICKS = 20_000
LEAST_TICKS, MOST_TICKS = 100, 2_000_000
USUAL = ("quiet", "motion", "push50", "push80", "weak")


@dataclass(frozen=True)
class BenchSettings:
    """Robot, length and program of a bench.

    Attributes:
        robot: A name of surefoot.available_robots(), or what describe_robot() returns of files.
        ticks: That are timed in each scenario, at least; its reports are replayed as often as that
            takes.
        form: Of the program that is timed.
        rate: Reports per second of the recorded runs [Hz].
        seed: Of their sensors' noise.
        scenarios: What is recorded: names in SCENARIOS.
    """

    robot: str | RobotDescription = "go1"
    ticks: int = TICKS
    form: Form = Form.AUTO
    rate: float = 500.0
    seed: int = 1
    scenarios: tuple[str, ...] = USUAL

    def __post_init__(self) -> None:
        if not LEAST_TICKS <= self.ticks <= MOST_TICKS:
            raise Error(f"ticks: got {self.ticks}, expected {LEAST_TICKS} to {MOST_TICKS}")
        check_rate(self.rate)
        for name in self.scenarios:
            if name not in SCENARIOS:
                raise Error(f"scenario: got '{name}', expected one of {', '.join(SCENARIOS)}")
