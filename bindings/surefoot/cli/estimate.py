"""surefoot estimate: a log through the state estimator to its results."""

from __future__ import annotations

import argparse
from pathlib import Path

from surefoot._core import Error
from surefoot.cli.progress import progress_bar
from surefoot.cli.robot_choice import chosen_robot
from surefoot.cli.simulation import (
    check_json_place,
    check_table_place,
    missing_module,
    write_json,
)
from surefoot.cli.stand import read_gains
from surefoot.estimate import read_log, run_estimator, summarise, write_trajectory
from surefoot.estimate.text import summary_text
from surefoot.robots import build_robot


def estimate(arguments: argparse.Namespace) -> None:
    """Read the log, run the estimator and print, write and draw what was asked for.

    Raises:
        Error: A wrong argument, or a log that is refused.
        OSError: A file could not be written.
    """
    check_json_place(arguments.json)
    check_table_place("--trajectory", arguments.trajectory)
    _check_report(arguments.report)
    description = chosen_robot(arguments, default="go1")
    assert description is not None  # there is a default
    gains = read_gains(arguments.gains, description)
    log = read_log(arguments.log)
    result = run_estimator(build_robot(description), log, gains, progress_bar())
    summary = summarise(result)
    write_json(arguments.json, summary)
    if arguments.trajectory is not None:
        write_trajectory(arguments.trajectory, result)
    if arguments.report is not None:
        from surefoot.estimate.report import write_report

        page = write_report(result, summary, arguments.report, ["surefoot", *arguments.words])
    if arguments.json != "-":
        print(summary_text(summary))
        if arguments.report is not None:
            print(f"  report    {page}")


def _check_report(folder: str | None) -> None:
    """Find out before the run, not after it, that the report cannot be written; raises Error."""
    if folder is None:
        return
    try:
        Path(folder).mkdir(parents=True, exist_ok=True)
        import surefoot.estimate.report  # noqa: F401
    except OSError as problem:
        raise Error(f"--report: cannot make the folder: {problem}") from None
    except ModuleNotFoundError as problem:
        raise missing_module("estimate --report", problem) from None
