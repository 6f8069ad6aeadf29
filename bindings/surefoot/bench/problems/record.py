"""Records the programs of a run, grouped by their size."""

from __future__ import annotations

import importlib.metadata
from collections import defaultdict
from collections.abc import Iterator
from typing import Any

from surefoot._core import Error, Form, QpProblem, StandController, StandOptions, is_usable
from surefoot.bench.problems.limp import run_limp
from surefoot.bench.problems.scenarios import SCENARIOS, Scenario
from surefoot.bench.problems.sequence import Sequence, make_sequence
from surefoot.robot_files import RobotDescription

LIMP = "limp"
NAMES = (*SCENARIOS, LIMP)
_PACKAGES = ("surefoot", "pin", "mujoco", "example-robot-data")


def record_problems(
    robot: str | RobotDescription, scenario: str, form: Form, rate: float = 500.0, seed: int = 1
) -> list[Sequence]:
    """Run a scenario and keep every program that was solved.

    Args:
        robot: A name of surefoot.available_robots(), or what describe_robot() returns of files.
        scenario: One of NAMES.
        form: CONDENSED or GENERAL.
        rate: Ticks per second [Hz].
        seed: Of the sensors' noise; the same seed gives the same programs.

    Returns:
        One sequence of hard programs, and one of those with slacks if any row ever gave.

    Raises:
        Error: An unknown name, or a robot that fell.
    """
    check_scenario(scenario)
    if scenario == LIMP:
        programs = run_limp(robot, form, rate, seed)
    else:
        programs = run_stand(robot, SCENARIOS[scenario], form, rate, seed)
    found: dict[int, tuple[list[int], list[QpProblem]]] = defaultdict(lambda: ([], []))
    for tick, program in programs:
        ticks, problems = found[len(program.g)]
        ticks.append(tick)
        problems.append(program)
    least = min(found)
    meta: dict[str, Any] = {
        "robot": robot if isinstance(robot, str) else robot.name,
        "scenario": scenario,
        "form": form.name.lower(),
        "rate": rate,
        "seed": seed,
        "versions": {name: importlib.metadata.version(name) for name in _PACKAGES},
    }
    return [
        make_sequence({**meta, "elastic": size > least}, *found[size]) for size in sorted(found)
    ]


def check_scenario(name: str) -> None:
    """Raise Error unless it is one of NAMES."""
    if name not in NAMES:
        raise Error(f"scenario: got '{name}', expected one of {', '.join(NAMES)}")


def run_stand(
    robot: str | RobotDescription, scenario: Scenario, form: Form, rate: float, seed: int
) -> Iterator[tuple[int, QpProblem]]:
    """Yield (tick, program) of the stand controller; a robot that falls ends the sequence."""
    plant = scenario.plant(robot, rate, seed)
    told = scenario.robot(plant.robot)
    controller = StandController(told, told.config.gains, StandOptions(form=form))
    report = plant.reset()
    for tick in range(round(scenario.duration * rate)):
        scenario.steer(controller, tick / rate)
        command = controller.update(report)
        if is_usable(controller.status):
            yield tick, controller.program
        report = plant.step(command)
        if plant.truth.fell:
            return
