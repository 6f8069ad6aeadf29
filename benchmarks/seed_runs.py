"""Many runs, each of a seed: on as many processes as there are, and said how far they are."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable
from concurrent.futures import as_completed
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TypeVar

from surefoot.processes import spawn_pool
from surefoot.store import open_store

ROBOTS = ("a1", "go1", "go2", "b1")

Job = tuple[str | int, ...]
"""What a run gets: of what, and last the seed."""


@dataclass
class Outcome:
    """What comes of a run; those of a benchmark have more."""

    ok: bool  # all is as it should be
    why: str  # what is not


Result = TypeVar("Result", bound=Outcome)


def add_seed_options(parser: argparse.ArgumentParser, count: int | None = None) -> None:
    """Add how many seeds to run, from which on, on how many processes, and where to keep them."""
    add = parser.add_argument
    if count is not None:
        add("--count", type=int, default=count, help=f"seeds of each ({count})")
    add("--first", type=int, default=0, help="the first seed (0)")
    add("--jobs", type=int, default=1, help="processes (1)")
    add("--store", metavar="FILE", help="keep every run when it is done; the same command goes on")
    add("--json", type=Path, metavar="FILE", help="write every run's figures here")


def seeds_of(options: argparse.Namespace) -> range:
    """Return the seeds that were asked for."""
    return range(options.first, options.first + options.count)


def run_seeds(
    run: Callable[[Job], Result],
    made: type[Result],
    jobs: list[Job],
    options: argparse.Namespace,
) -> list[Result]:
    """Run every job that the store does not have, and return what came of all, in their order.

    Failures are printed at once; how far it is goes to stderr.

    Args:
        run: Runs one, in another process.
        made: What it returns; plain fields.
        jobs: What it gets.
        options: As add_seed_options() has them.
    """
    begin = time.monotonic()
    with (
        open_store(options.store, Path(sys.argv[0]).name, {}) as store,
        spawn_pool(options.jobs) as pool,
    ):
        left = [job for job in jobs if label(job) not in store.results]
        waiting = {pool.submit(run, job): job for job in left}
        for k, done in enumerate(as_completed(waiting), len(jobs) - len(left) + 1):
            outcome = done.result()
            store.add(*label(waiting[done]), asdict(outcome))
            if not outcome.ok:
                print(f"{' '.join(label(waiting[done]))}: {outcome.why}", flush=True)
            line = f"{k} of {len(jobs)}, {time.monotonic() - begin:.0f} s"
            if sys.stderr.isatty():
                print(line, end="\r", file=sys.stderr, flush=True)
            elif k % 50 == 0:
                print(line, file=sys.stderr, flush=True)
        return [made(**store.results[label(job)]) for job in jobs]


def label(job: Job) -> tuple[str, str]:
    """Return of what a job is, and its seed."""
    return " ".join(str(part) for part in job[:-1]), f"seed {job[-1]}"
