"""Entry point of an assessment: runs all units without a stored result, then scores all units."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from surefoot.assess.failure_films import make_films
from surefoot.assess.foreign_plant import ForeignPlant
from surefoot.assess.plan import planned_work
from surefoot.assess.push_limits import PushLimits
from surefoot.assess.score import controller_results, score
from surefoot.assess.settings import AssessSettings
from surefoot.assess.walking.walk_plan import planned_walks
from surefoot.assess.walking.walk_score import walk_score
from surefoot.assess.worker import LOST_KEY, WorkItem
from surefoot.assess.worker_pool import run_work
from surefoot.files.result_store import ResultStore, open_result_store

Progress = Callable[[str, int, int], None]
"""Function that receives the name of an activity, the steps done, and the total of its steps."""


def run_assess(
    settings: AssessSettings, progress: Progress | None = None, films: Path | None = None
) -> dict[str, Any]:
    """Run an assessment, or resume the one in the store.

    Args:
        settings: Settings of the assessment.
        progress: Function that is called after every unit.
        films: Folder for films of the failures; None: no films. Walks are not filmed.

    Returns:
        The filled scorecard as JSON values; docs/reference/scorecard.md describes its keys.

    Raises:
        Error: The robot, controller, scorecard or store is invalid.
        OSError: The store cannot be written; it keeps the results written before.
    """
    robot = settings.build()
    limits = PushLimits(robot)
    walks = settings.controller_under_test.walks
    planned = list(planned_walks(settings, limits) if walks else planned_work(settings, limits))
    foreign = None if settings.mjcf is None else ForeignPlant(settings, robot, settings.mjcf)
    if foreign is not None:
        planned += [WorkItem(unit, settings.controller_under_test) for unit in foreign.units()]
    with open_result_store(settings.store, "surefoot assess", settings.to_dict(robot)) as store:
        _run(settings, store, planned, progress)
        unit_results = controller_results(store.results, settings.controller_under_test.name)
        section = None if foreign is None else foreign.section(unit_results)
        if walks:
            return walk_score(settings, robot, limits, store.results, section)
        filled = score(settings, robot, limits, store.results, section)
    filled["films"] = [] if films is None else make_films(settings, limits, unit_results, films)
    return filled


def _run(
    settings: AssessSettings, store: ResultStore, planned: list[WorkItem], progress: Progress | None
) -> None:
    # A resumed run repeats lost units, because the machine may have caused the loss.
    finished = {key for key, unit_result in store.results.items() if LOST_KEY not in unit_result}
    missing = [w for w in planned if (w.controller_under_test.name, w.unit.key) not in finished]
    done = len(planned) - len(missing)
    jobs = min(settings.jobs, max(1, len(missing)))
    for work, result in run_work(missing, settings.robot, jobs, settings.deadline):
        store.add(work.controller_under_test.name, work.unit.key, result)
        done += 1
        if progress is not None:
            progress("assess", done, len(planned))
