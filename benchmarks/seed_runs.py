"""Many runs, each of a seed: on as many processes as there are, and said how far they are."""

from __future__ import annotations

import argparse
import hashlib
import inspect
import sys
import time
from collections.abc import Callable
from concurrent.futures import as_completed
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TypeVar

from surefoot import Error, available_robots
from surefoot.cli.progress import kept_in
from surefoot.cli.simulation import check_place
from surefoot.processes import killable_pool
from surefoot.robots import build
from surefoot.store import open_store

ROBOTS = tuple(available_robots())

Job = tuple[str | int, ...]
"""What a run gets: of what, and last the seed."""


@dataclass
class Outcome:
    """What comes of a run; those of a benchmark have more."""

    ok: bool  # all is as it should be
    why: str  # what is not


Result = TypeVar("Result", bound=Outcome)


def whole(text: str, low: int) -> int:
    """Return the whole number that an option's text is, from `low` up."""
    value = int(text)
    if value < low:
        raise argparse.ArgumentTypeError(f"got {value}, expected a whole number from {low} up")
    return value


def add_seed_options(parser: argparse.ArgumentParser, count: int | None = None) -> None:
    """Add how many seeds to run, from which on, on how many processes, and where to keep them."""
    add = parser.add_argument

    def positive(text: str) -> int:
        return whole(text, 1)

    if count is not None:
        add("--count", type=positive, default=count, help=f"seeds of each ({count})")
    add("--first", type=lambda text: whole(text, 0), default=0, help="the first seed (0)")
    add("--jobs", type=positive, default=1, help="processes (1)")
    add("--store", metavar="FILE", help="keep every run when it is done; the same command goes on")
    add("--json", metavar="FILE", help="write the figures here")


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

    Failures are printed at once; how far it is goes to stderr. Arguments that cannot be end the
    program, with status 2.

    Args:
        run: Runs one, in another process.
        made: What it returns; plain fields.
        jobs: What it gets.
        options: As add_seed_options() has them.
    """
    script = Path(sys.argv[0]).name
    jobs = list(dict.fromkeys(jobs))
    begin = time.monotonic()
    try:
        check_place("--store", options.store)
        check_place("--json", options.json)
        with (
            open_store(options.store, script, {"build": build(), "script": text_of(run)}) as store,
            kept_in(options.store),
            killable_pool(options.jobs) as pool,
        ):
            found = {job: made(**r) for job in jobs if (r := store.results.get(label(job)))}
            for job, outcome in found.items():
                tell(job, outcome)
            waiting = {pool.submit(run, job): job for job in jobs if job not in found}
            for done in as_completed(waiting):
                job = waiting[done]
                found[job] = done.result()
                store.add(*label(job), asdict(found[job]))
                tell(job, found[job])
                show(len(found), len(jobs), time.monotonic() - begin)
    except Error as problem:
        print(f"{script}: {problem}", file=sys.stderr)
        sys.exit(2)
    return [found[job] for job in jobs]


def text_of(run: Callable[[Job], Result]) -> str:
    """Return a digest of the file that says how a run goes: others' results are not its own."""
    file = inspect.getsourcefile(run)
    assert file
    return hashlib.sha256(Path(file).read_bytes()).hexdigest()[:16]


def tell(job: Job, outcome: Outcome) -> None:
    """Print what is not as it should be."""
    if not outcome.ok:
        print(f"{' '.join(label(job))}: {outcome.why}", flush=True)


def show(done: int, total: int, seconds: float) -> None:
    """Say how far it is: on one line of a terminal, or now and then."""
    terminal = sys.stderr.isatty()
    if terminal or done % 50 == 0:
        end = "\r" if terminal else "\n"
        print(f"{done} of {total}, {seconds:.0f} s", end=end, file=sys.stderr, flush=True)


def label(job: Job) -> tuple[str, str]:
    """Return of what a job is, and its seed."""
    return " ".join(str(part) for part in job[:-1]), f"seed {job[-1]}"
