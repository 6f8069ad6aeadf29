"""Recording of the QPs of a run, grouped by their size."""

from __future__ import annotations

import importlib.metadata
from collections import defaultdict
from collections.abc import Iterator
from typing import Any

from surefoot._core import Error, QpForm, QpProblem, is_usable
from surefoot.bench.problems.qp_sequence import QpSequence, make_qp_sequence
from surefoot.bench.problems.scenarios import SCENARIOS, Scenario
from surefoot.bench.problems.three_legged_stance import run_three_legged_stance
from surefoot.robot.description import RobotDescription

THREE_LEGGED_STANCE = "limp"
SCENARIO_NAMES = (*SCENARIOS, THREE_LEGGED_STANCE)
_PACKAGES = ("surefoot", "pin", "mujoco", "example-robot-data")


def record_problems(
    robot: str | RobotDescription, scenario: str, form: QpForm, rate: float = 500.0, seed: int = 1
) -> list[QpSequence]:
    """Run a scenario and record every solved QP.

    Args:
        robot: A name of surefoot.available_robots(), or the result of describe_robot().
        scenario: One of SCENARIO_NAMES.
        form: QP form, CONDENSED or GENERAL.
        rate: Ticks per second [Hz].
        seed: Seed of the sensor noise; the same seed gives the same QPs.

    Returns:
        One sequence of QPs without slacks, and one of QPs with slacks if any tick needed slacks.

    Raises:
        Error: The robot or the scenario is unknown, or the robot fell on three legs.
    """
    check_scenario(scenario)
    if scenario == THREE_LEGGED_STANCE:
        all_problems = run_three_legged_stance(robot, form, rate, seed)
    else:
        all_problems = controller_problems(robot, SCENARIOS[scenario], form, rate, seed)
    found: dict[int, tuple[list[int], list[QpProblem]]] = defaultdict(lambda: ([], []))
    for tick, problem in all_problems:
        ticks, problems = found[len(problem.g)]
        ticks.append(tick)
        problems.append(problem)
    smallest_size = min(found)
    meta: dict[str, Any] = {
        "robot": robot if isinstance(robot, str) else robot.name,
        "scenario": scenario,
        "form": form.name.lower(),
        "rate": rate,
        "seed": seed,
        "versions": {name: importlib.metadata.version(name) for name in _PACKAGES},
    }
    return [
        make_qp_sequence({**meta, "elastic": size > smallest_size}, *found[size])
        for size in sorted(found)
    ]


def check_scenario(name: str) -> None:
    """Raise Error unless `name` is one of SCENARIO_NAMES."""
    if name not in SCENARIO_NAMES:
        raise Error(f"scenario: got '{name}', expected one of {', '.join(SCENARIO_NAMES)}")


def controller_problems(
    robot: str | RobotDescription, scenario: Scenario, form: QpForm, rate: float, seed: int
) -> Iterator[tuple[int, QpProblem]]:
    """Yield (tick, QP) of the scenario's controller; end when the robot falls."""
    plant = scenario.make_plant(robot, rate, seed)
    controller = scenario.make_controller(scenario.controller_robot(plant.robot), form)
    low_state = plant.reset()
    for tick in range(round(scenario.duration * rate)):
        scenario.apply_requests(controller, tick / rate)
        command = controller.update(low_state)
        if is_usable(controller.status):
            yield tick, controller.qp
        low_state = plant.step(command)
        if plant.truth.fell:
            return
