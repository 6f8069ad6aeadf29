"""Settings of a benchmark."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot._core import Error, QpForm
from surefoot.bench.problems import SCENARIOS
from surefoot.robot.description import RobotDescription
from surefoot.stand.simulation_settings import check_rate

# Chosen: 20 of these ticks lie above the 99.9th percentile, enough to estimate this percentile.
DEFAULT_TICKS = 20_000
# Sanity limits.
MIN_TICKS, MAX_TICKS = 100, 2_000_000
DEFAULT_SCENARIOS = ("quiet", "motion", "push50", "push80", "weak", "trot", "walk")


@dataclass(frozen=True)
class BenchSettings:
    """Robot, scenarios, number of ticks and form of the QP.

    Attributes:
        robot: A name of surefoot.available_robots(), or the result of describe_robot().
        ticks: Smallest number of timed ticks per scenario. The recording is replayed until this
            number is reached.
        form: Form of the QP that is timed.
        rate: Rate of the LowStates in the recorded runs [Hz].
        seed: Seed of the sensor noise.
        scenarios: Names of the SCENARIOS to record and time.
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
