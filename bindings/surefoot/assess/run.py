"""The assessment: every unit run or found in the store, then scored."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from surefoot.assess.crew import run_all
from surefoot.assess.films import make_films
from surefoot.assess.plan import works
from surefoot.assess.push_limits import Limits
from surefoot.assess.score import of_contestant, score
from surefoot.assess.settings import AssessSettings
from surefoot.assess.worker import LOST, Work
from surefoot.store import Store, open_store

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
    limits = Limits(robot)
    with open_store(settings.store, "surefoot assess", settings.described(robot)) as store:
        _run(settings, store, list(works(settings, limits)), progress)
        filled = score(settings, robot, limits, store.results)
        found = of_contestant(store.results, settings.contestant.name)
    filled["films"] = [] if films is None else make_films(settings, limits, found, films)
    return filled


def _run(
    settings: AssessSettings, store: Store, planned: list[Work], progress: Progress | None
) -> None:
    # What never came to its end may have been the machine's fault: a run that goes on tries again.
    whole = {key for key, found in store.results.items() if LOST not in found}
    left = [w for w in planned if (w.contestant.name, w.unit.key) not in whole]
    done = len(planned) - len(left)
    jobs = min(settings.jobs, max(1, len(left)))
    for work, result in run_all(left, settings.robot, jobs, settings.deadline):
        store.add(work.contestant.name, work.unit.key, result)
        done += 1
        if progress is not None:
            progress("assess", done, len(planned))
