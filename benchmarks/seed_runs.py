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
from surefoot.cli.environment import check_output_path
from surefoot.cli.progress import report_kept_results
from surefoot.files.result_store import open_result_store
from surefoot.robot.loading import package_digest
from surefoot.system.worker_processes import killable_pool

ROBOTS = tuple(available_robots())

Job = tuple[str | int, ...]
"""What a run gets: of what, and last the seed."""


@dataclass
class RunOutcome:
    """What comes of a run; those of a benchmark have more."""

    ok: bool  # all is as it should be
    why: str  # what is not


Result = TypeVar("Result", bound=RunOutcome)


def parse_integer(text: str, low: int) -> int:
    """Return the whole number that an option's text is, from `low` up."""
    value = int(text)
    if value < low:
        raise argparse.ArgumentTypeError(f"got {value}, expected a whole number from {low} up")
    return value


def add_seed_options(parser: argparse.ArgumentParser, count: int | None = None) -> None:
    """Add how many seeds to run, from which on, on how many processes, and where to keep them."""
    add = parser.add_argument

    def positive(text: str) -> int:
        return parse_integer(text, 1)

    if count is not None:
        add("--count", type=positive, default=count, help=f"seeds of each ({count})")
    add("--first", type=lambda text: parse_integer(text, 0), default=0, help="the first seed (0)")
    add("--jobs", type=positive, default=1, help="processes (1)")
    add("--store", metavar="FILE", help="keep every run when it is done; the same command goes on")
    add("--json", metavar="FILE", help="write the figures here")


def seeds_of(options: argparse.Namespace) -> range:
    """Return the seeds that were asked for."""
    return range(options.first, options.first + options.count)


def run_seeds(
    run: Callable[[Job], Result],
    outcome_type: type[Result],
    jobs: list[Job],
    options: argparse.Namespace,
) -> list[Result]:
    """Run every job that the store does not have, and return what came of all, in their order.

    Failures are printed at once; how far it is goes to stderr. Arguments that cannot be end the
    program, with status 2.

    Args:
        run: Runs one, in another process.
        outcome_type: What it returns; plain fields.
        jobs: What it gets.
        options: As add_seed_options() has them.
    """
    script = Path(sys.argv[0]).name
    jobs = list(dict.fromkeys(jobs))
    begin = time.monotonic()
    try:
        check_output_path("--store", options.store)
        check_output_path("--json", options.json)
        with (
            open_result_store(
                options.store, script, {"build": package_digest(), "script": source_digest(run)}
            ) as store,
            report_kept_results(options.store),
            killable_pool(options.jobs) as pool,
        ):
            outcomes = {
                job: outcome_type(**r)
                for job in jobs
                if (r := store.results.get(job_and_seed(job)))
            }
            for job, outcome in outcomes.items():
                print_failure(job, outcome)
            futures = {pool.submit(run, job): job for job in jobs if job not in outcomes}
            for done in as_completed(futures):
                job = futures[done]
                outcomes[job] = done.result()
                store.add(*job_and_seed(job), asdict(outcomes[job]))
                print_failure(job, outcomes[job])
                print_progress(len(outcomes), len(jobs), time.monotonic() - begin)
    except Error as problem:
        print(f"{script}: {problem}", file=sys.stderr)
        sys.exit(2)
    return [outcomes[job] for job in jobs]


def source_digest(run: Callable[[Job], Result]) -> str:
    """Return a digest of the file that says how a run goes: others' results are not its own."""
    file = inspect.getsourcefile(run)
    assert file
    return hashlib.sha256(Path(file).read_bytes()).hexdigest()[:16]


def print_failure(job: Job, outcome: RunOutcome) -> None:
    """Print what is not as it should be."""
    if not outcome.ok:
        print(f"{' '.join(job_and_seed(job))}: {outcome.why}", flush=True)


def print_progress(done: int, total: int, seconds: float) -> None:
    """Say how far it is: on one line of a terminal, or now and then."""
    terminal = sys.stderr.isatty()
    if terminal or done % 50 == 0:
        end = "\r" if terminal else "\n"
        print(f"{done} of {total}, {seconds:.0f} s", end=end, file=sys.stderr, flush=True)


def job_and_seed(job: Job) -> tuple[str, str]:
    """Return of what a job is, and its seed."""
    return " ".join(str(part) for part in job[:-1]), f"seed {job[-1]}"
