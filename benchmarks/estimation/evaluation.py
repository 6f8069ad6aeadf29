"""All cases: which logs each needs, and how one seed of it becomes figures."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from surefoot import Robot, load_robot

from estimation.biases import bias
from estimation.cache import load_or_record
from estimation.cases import SCENARIOS
from estimation.dropping import dropout
from estimation.figures import Result
from estimation.loaded import payload
from estimation.log_rows import Log
from estimation.standing import push60, quiet, quiet_long
from estimation.starting import init
from estimation.touching import contact

CaseFunction = Callable[[Robot, dict[str, Log], int], Result]


@dataclass(frozen=True)
class Case:
    """One case.

    Attributes:
        scenarios: Recorded scenarios by name.
        evaluate: Makes figures of them; None for the payload, which has no logs.
        seeds: At most so many, for they are long.
    """

    scenarios: tuple[str, ...]
    evaluate: CaseFunction | None
    seeds: int = 1000


CASES: dict[str, Case] = {
    "quiet": Case(("quiet",), quiet),
    "quiet_long": Case(("quiet_long",), quiet_long, 1),
    "push60": Case(("push60",), push60),
    "contact": Case(("lifts", "steps", "feet"), contact),
    "init": Case(("quiet", "shove"), init),
    "dropout": Case(("push60",), dropout),
    "bias": Case(("bias",), bias),
    "payload": Case((), None),
}


@dataclass(frozen=True)
class Task:
    """One seed of one case of one robot."""

    robot: str
    case: str
    seed: int
    folder: Path
    record_only: bool = False


def run_task(task: Task) -> tuple[Task, Result]:
    """Record what is not there yet, and evaluate."""
    case = CASES[task.case]
    if case.evaluate is None:
        return task, Result({}) if task.record_only else payload(task.robot, task.seed)
    logs = {
        name: load_or_record(task.folder, name, task.seed, SCENARIOS[name](task.robot, task.seed))
        for name in case.scenarios
    }
    if task.record_only:
        return task, Result({})
    return task, case.evaluate(load_robot(task.robot), logs, task.seed)
