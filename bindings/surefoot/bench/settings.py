"""What a bench is asked to be."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot._core import Error, QpForm
from surefoot.bench.problems import SCENARIOS
from surefoot.robot.description import RobotDescription
from surefoot.stand.settings import check_rate

DEFAULT_TICKS = 20_000
MIN_TICKS, MAX_TICKS = 100, 2_000_000
DEFAULT_SCENARIOS = ("quiet", "motion", "push50", "push80", "weak")


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
    ticks: int = DEFAULT_TICKS
    form: QpForm = QpForm.AUTO
    rate: float = 500.0
    seed: int = 1
    scenarios: tuple[str, ...] = DEFAULT_SCENARIOS

    def __post_init__(self) -> None:
        if not MIN_TICKS <= self.ticks <= MAX_TICKS:
            raise Error(f"ticks: got {self.ticks}, expected {MIN_TICKS} to {MAX_TICKS}")
        check_rate(self.rate)
        for name in self.scenarios:
            if name not in SCENARIOS:
                raise Error(f"scenario: got '{name}', expected one of {', '.join(SCENARIOS)}")
