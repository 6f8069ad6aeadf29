"""Reports of a simulated run, recorded first so that timing has the machine to itself."""

from __future__ import annotations

from dataclasses import dataclass

from surefoot._core import Error, LowState, Robot, StandController
from surefoot.bench.settings import PUSH_LENGTH, PUSH_SHARE, BenchSettings
from surefoot.sim import Plant, PlantSettings, Push

PUSH_AT = 0.5  # of the run: half of it quiet standing, half a push and what comes after


@dataclass(frozen=True)
class Recording:
    """What the sensors said, report after report.

    Attributes:
        robot: The controller's model.
        reports: One LowState per tick.
        period: From report to report [s].
        push: The push in it.
    """

    robot: Robot
    reports: list[LowState]
    period: float
    push: Push


def record(settings: BenchSettings) -> Recording:
    """Let the robot stand and be pushed, and keep every report; raises Error if it falls.

    The controller chooses its form as it does by itself, whatever form is timed later: every form
    is timed on the same reports.
    """
    plant = Plant(settings.robot, PlantSettings(control_rate=settings.rate, seed=settings.seed))
    duration = settings.ticks / settings.rate
    impulse = PUSH_SHARE * plant.lip_limit("lateral", PUSH_LENGTH)
    push = Push("lateral", impulse, PUSH_LENGTH, PUSH_AT * duration)
    plant.add_push(push)
    controller = StandController(plant.robot)
    report = plant.reset()
    reports = []
    for _ in range(settings.ticks):
        # A copy: whose memory the next report takes is the plant's business.
        reports.append(LowState.from_bytes(report.to_bytes()))
        report = plant.step(controller.update(report))
        if plant.truth.fell:
            raise Error(
                f"bench: got a {plant.robot.name} that fell after {plant.time:g} s, expected one "
                f"that stands a push of {100 * PUSH_SHARE:.0f} %"
            )
    return Recording(plant.robot, reports, 1.0 / settings.rate, push)
