"""The assessment: every unit run or found in the store, then scored."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from surefoot.assess.failure_films import make_films
from surefoot.assess.plan import planned_work
from surefoot.assess.push_limits import PushLimits
from surefoot.assess.score import controller_results, score
from surefoot.assess.settings import AssessSettings
from surefoot.assess.worker import LOST_KEY, WorkItem
from surefoot.assess.worker_pool import run_work
from surefoot.files.result_store import ResultStore, open_result_store

Progress = Callable[[str, int, int], None]
"""Called with what is being done, how much of it is done, and how much there is."""


def run_assess(
    settings: AssessSettings, progress: Progress | None = None, films: Path | None = None
) -> dict[str, Any]:
    """Run an assessment to its end, or go on with the one in the store.

    Args:
        settings: What to run.
        progress: Told how far it is.
        films: Folder for films of the failures; None makes none.

    Returns:
        The card filled in, as plain JSON types; docs/assess.md says what is where.

    Raises:
        Error: A robot, controller, card or store that does not do.
        OSError: The store cannot be written; what is in it is safe.
    """
    robot = settings.build()
    limits = PushLimits(robot)
    with open_result_store(settings.store, "surefoot assess", settings.to_dict(robot)) as store:
        _run(settings, store, list(planned_work(settings, limits)), progress)
        filled = score(settings, robot, limits, store.results)
        unit_results = controller_results(store.results, settings.controller_under_test.name)
    filled["films"] = [] if films is None else make_films(settings, limits, unit_results, films)
    return filled


def _run(
    settings: AssessSettings, store: ResultStore, planned: list[WorkItem], progress: Progress | None
) -> None:
    # What never came to its end may have been the machine's fault: a run that goes on tries again.
    finished = {key for key, unit_result in store.results.items() if LOST_KEY not in unit_result}
    missing = [w for w in planned if (w.controller_under_test.name, w.unit.key) not in finished]
    done = len(planned) - len(missing)
    jobs = min(settings.jobs, max(1, len(missing)))
    for work, result in run_work(missing, settings.robot, jobs, settings.deadline):
        store.add(work.controller_under_test.name, work.unit.key, result)
        done += 1
        if progress is not None:
            progress("assess", done, len(planned))
