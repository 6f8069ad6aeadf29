"""Reports of a simulated run, recorded first so that timing has the machine to itself."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot._core import BodyReference, LowState, Robot, StandController
from surefoot.bench.problems import SCENARIOS
from surefoot.bench.settings import BenchSettings


@dataclass(frozen=True)
class Recording:
    """What the sensors said, report after report.

    Attributes:
        scenario: A name in SCENARIOS.
        robot: The model that the controller was given.
        reports: One LowState per tick, from standing to the end or to the fall.
        period: From report to report [s].
        fell: Did the robot fall at the end?
        references: What the body was asked for before each report; none if it was never asked.
    """

    scenario: str
    robot: Robot
    reports: list[LowState]
    period: float
    fell: bool
    references: tuple[BodyReference, ...] = ()


def record(settings: BenchSettings, scenario: str = "push50") -> Recording:
    """Run a scenario and keep every report.

    The controller chooses its form as it does by itself, whatever form is timed later: every form
    is timed on the same reports.
    """
    definition = SCENARIOS[scenario]
    plant = definition.make_plant(settings.robot, settings.rate, settings.seed)
    robot = definition.controller_robot(plant.robot)
    controller = StandController(robot)
    report = plant.reset()
    reports, references = [], []
    for tick in range(round(definition.duration * settings.rate)):
        # A copy: whose memory the next report takes is the plant's business.
        reports.append(LowState.from_bytes(report.to_bytes()))
        definition.apply_reference(controller, tick / settings.rate)
        if definition.body_reference is not None:
            references.append(definition.body_reference(tick / settings.rate))
        report = plant.step(controller.update(report))
        if plant.truth.fell:
            break
    period = 1.0 / settings.rate
    return Recording(scenario, robot, reports, period, plant.truth.fell, tuple(references))
