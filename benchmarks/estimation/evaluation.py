"""Cases of the benchmark, each with its scenarios and its evaluation for one seed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from surefoot import Robot, load_robot

from estimation.cache import load_or_record
from estimation.contact_case import contact
from estimation.dropout_case import dropout
from estimation.hand_case import hand
from estimation.imu_bias_case import bias
from estimation.initialization_case import init
from estimation.log_rows import Log
from estimation.metrics import Result
from estimation.payload_case import payload
from estimation.scenarios import SCENARIOS
from estimation.standing_case import push60, quiet, quiet_long
from estimation.walking_case import walking
from estimation.walking_scenarios import WALKING_SCENARIOS

RECORDINGS = {**SCENARIOS, **WALKING_SCENARIOS}
CaseFunction = Callable[[Robot, dict[str, Log], int], Result]


@dataclass(frozen=True)
class Case:
    """One case of the benchmark.

    Attributes:
        scenarios: Names of the recorded scenarios.
        evaluate: Function that computes the figures; None for the payload, which has no logs.
        seeds: Largest number of seeds, for cases with long runs.
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
    "hand": Case((), hand),
    "walking": Case(tuple(WALKING_SCENARIOS), walking),
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
    """Record the logs that are not in the cache yet, and evaluate the case."""
    case = CASES[task.case]
    if case.evaluate is None:
        return task, Result({}) if task.record_only else payload(task.robot, task.seed)
    logs = {
        name: load_or_record(task.folder, name, task.seed, RECORDINGS[name](task.robot, task.seed))
        for name in case.scenarios
    }
    if task.record_only:
        return task, Result({})
    return task, case.evaluate(load_robot(task.robot), logs, task.seed)
