"""Benchmark of the state estimator: record missing logs, replay them, and print pass or miss.

    python benchmarks/estimation/run.py --robot go1 --seeds 20 --jobs 2 --case push60 contact

Default: all cases and all four robots. Logs are kept in --folder. They depend on the controller
that recorded them, so remove the folder to record with another version.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from multiprocessing import get_context
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from estimation.evaluation import CASES, Task, run_task
from estimation.metrics import Result
from estimation.report import summarise, table

ROBOTS = ("a1", "go1", "go2", "b1")


def parse_arguments() -> argparse.Namespace:
    """Read the command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--robot", nargs="+", choices=ROBOTS, default=list(ROBOTS))
    parser.add_argument("--case", nargs="+", choices=tuple(CASES), default=list(CASES))
    parser.add_argument("--seeds", type=int, default=20, help="seeds 0 .. N - 1")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--folder", type=Path, default=Path("out/estimation"))
    parser.add_argument("--json", type=Path, help="also write the rows as JSON")
    parser.add_argument(
        "--record-only", action="store_true", help="record the logs without evaluation"
    )
    return parser.parse_args()


def make_tasks(options: argparse.Namespace) -> list[Task]:
    """Return a task for every seed of every case of every robot."""
    return [
        Task(robot, case, seed, options.folder, options.record_only)
        for robot in options.robot
        for case in options.case
        for seed in range(min(options.seeds, CASES[case].seeds))
    ]


def run_all(tasks: list[Task], jobs: int) -> list[tuple[Task, Result]]:
    """Run the tasks in parallel processes; print progress to stderr if it is a terminal."""
    results = []
    with get_context("spawn").Pool(jobs) as pool:
        for result in pool.imap_unordered(run_task, tasks):
            results.append(result)
            if sys.stderr.isatty():
                print(f"\r{len(results)} of {len(tasks)}", end="", file=sys.stderr)
    return sorted(results, key=lambda pair: pair[0].seed)


def main() -> None:
    """Run all tasks and print the table."""
    options = parse_arguments()
    rows = summarise(run_all(make_tasks(options), options.jobs))
    if options.json is not None:
        text = json.dumps([row.json() for row in rows], indent=1)
        options.json.write_text(text + "\n", encoding="utf-8")
    if not options.record_only:
        print(table(rows))


if __name__ == "__main__":
    main()
