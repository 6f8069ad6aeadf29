"""Runs of a benchmark over many seeds, in parallel processes, with progress and a result store."""

from __future__ import annotations

import argparse
import hashlib
import inspect
import sys
import time
from collections import Counter
from collections.abc import Callable
from concurrent.futures import as_completed
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TypeVar

from surefoot import Error, available_robots
from surefoot.cli.output_files import check_output_path, write_json
from surefoot.cli.progress import report_kept_results
from surefoot.files.result_store import open_result_store
from surefoot.robot.loading import package_digest
from surefoot.system.worker_processes import killable_pool

ROBOTS = tuple(available_robots())

Job = tuple[str | int, ...]
"""Arguments of a run. The last argument is the seed; the others name the subject, as the robot."""


@dataclass
class RunOutcome:
    """Result of a run. Each benchmark derives a class with further fields."""

    ok: bool  # whether the run passed
    why: str  # reason of a failure, else empty


@dataclass
class MutantOutcome(RunOutcome):
    """Result of a run with a mutated input: what was changed, how the run ended, and its text."""

    end: str
    message: str
    changes: list[str]


Result = TypeVar("Result", bound=RunOutcome)


def parse_integer(text: str, low: int) -> int:
    """Parse an option as an integer >= low; raise ArgumentTypeError for other text."""
    value = int(text)
    if value < low:
        raise argparse.ArgumentTypeError(f"got {value}, expected an integer >= {low}")
    return value


def add_seed_options(parser: argparse.ArgumentParser, count: int | None = None) -> None:
    """Add options for the number of seeds, the first seed, the processes, and the result files."""
    add = parser.add_argument

    def positive(text: str) -> int:
        return parse_integer(text, 1)

    if count is not None:
        add("--count", type=positive, default=count, help=f"number of seeds per case ({count})")
    add("--first", type=lambda text: parse_integer(text, 0), default=0, help="first seed (0)")
    add("--jobs", type=positive, default=1, help="number of processes (1)")
    add("--store", metavar="FILE", help="store each result; the same command continues from it")
    add("--json", metavar="FILE", help="write the figures to FILE")


def seeds_of(options: argparse.Namespace) -> range:
    """Return the requested seeds."""
    return range(options.first, options.first + options.count)


def run_seeds(
    run: Callable[[Job], Result],
    outcome_type: type[Result],
    jobs: list[Job],
    options: argparse.Namespace,
) -> list[Result]:
    """Run every job that is not in the store; return the results of all jobs, in order of `jobs`.

    Each failed run is printed at once. Progress is printed to stderr. Invalid options end the
    process with status 2.

    Args:
        run: Function that runs one job, in another process.
        outcome_type: Result type of `run`, a dataclass of JSON values.
        jobs: Jobs to run; duplicates run once.
        options: Options of add_seed_options().
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


def run_mutants(run: Callable[[Job], MutantOutcome], key: str, options: argparse.Namespace) -> int:
    """Run a mutant per seed, the robots in turn; print counts, write JSON; return 3 if one fails.

    Args:
        run: Function that runs the mutant of a robot and a seed, in another process.
        key: Name of the list of outcomes in the JSON object.
        options: Options of add_seed_options() with a count.
    """
    print(f"seeds {options.first} .. {options.first + options.count - 1}")
    jobs: list[Job] = [(ROBOTS[seed % len(ROBOTS)], seed) for seed in seeds_of(options)]
    outcomes = run_seeds(run, MutantOutcome, jobs, options)
    counts = Counter(outcome.end for outcome in outcomes)
    failed = sum(not outcome.ok for outcome in outcomes)
    print(", ".join(f"{count} {end}" for end, count in sorted(counts.items())))
    print(f"{failed} of {len(outcomes)} fail")
    result = {"counts": counts, "failed": failed, key: [asdict(one) for one in outcomes]}
    write_json(options.json, result, 1)
    return 3 if failed else 0


def source_digest(run: Callable[[Job], Result]) -> str:
    """Return a digest of the source file of `run`; results of other versions are ignored."""
    file = inspect.getsourcefile(run)
    assert file
    return hashlib.sha256(Path(file).read_bytes()).hexdigest()[:16]


def print_failure(job: Job, outcome: RunOutcome) -> None:
    """Print the reason of a failed run."""
    if not outcome.ok:
        print(f"{' '.join(job_and_seed(job))}: {outcome.why}", flush=True)


def print_progress(done: int, total: int, seconds: float) -> None:
    """Print progress to stderr: one line on a terminal, else every 50 runs."""
    terminal = sys.stderr.isatty()
    if terminal or done % 50 == 0:
        end = "\r" if terminal else "\n"
        print(f"{done} of {total}, {seconds:.0f} s", end=end, file=sys.stderr, flush=True)


def job_and_seed(job: Job) -> tuple[str, str]:
    """Return the subject of a job and its seed as text."""
    return " ".join(str(part) for part in job[:-1]), f"seed {job[-1]}"
