"""Many runs, each of a seed: on as many processes as there are, and said how far they are."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from concurrent.futures import as_completed
from typing import Protocol, TypeVar

from surefoot.processes import spawn_pool


class Outcome(Protocol):
    """What comes of a run: whether it is as it should be, and if not, why."""

    @property
    def ok(self) -> bool:
        """Is all as it should be?"""

    @property
    def why(self) -> str:
        """What is not."""


Job = TypeVar("Job")
Result = TypeVar("Result", bound=Outcome)


def run_seeds(
    run: Callable[[Job], Result],
    jobs: list[Job],
    processes: int,
    label: Callable[[Result], str],
) -> list[Result]:
    """Run every job and return what came of them, as they came.

    Failures are printed at once, by their label; how far it is goes to stderr.
    """
    outcomes: list[Result] = []
    begin = time.monotonic()
    with spawn_pool(processes) as pool:
        for done in as_completed([pool.submit(run, job) for job in jobs]):
            outcome = done.result()
            outcomes.append(outcome)
            if not outcome.ok:
                print(f"{label(outcome)}: {outcome.why}", flush=True)
            stand = sum(o.ok for o in outcomes)
            line = (
                f"{len(outcomes)} of {len(jobs)}, {stand} stand, {time.monotonic() - begin:.0f} s"
            )
            if sys.stderr.isatty():
                print(line, end="\r", file=sys.stderr, flush=True)
            elif len(outcomes) % 50 == 0:
                print(line, file=sys.stderr, flush=True)
    return outcomes
