"""surefoot estimate: runs the state estimator on a log and writes its results."""

from __future__ import annotations

import argparse

from surefoot.cli.output_files import (
    check_json_path,
    check_report_folder,
    check_table_path,
    write_json,
)
from surefoot.cli.progress import progress_bar
from surefoot.cli.robot_choice import chosen_robot
from surefoot.cli.stand import read_gains
from surefoot.estimate import read_log, run_estimator, summarise, write_trajectory
from surefoot.estimate.summary_text import summary_text
from surefoot.robot.loading import build_robot


def estimate(arguments: argparse.Namespace) -> None:
    """Read the log, run the estimator, print a summary and write the requested files.

    Raises:
        Error: A wrong argument, or an invalid log.
        OSError: A file could not be written.
    """
    check_json_path(arguments.json)
    check_table_path("--trajectory", arguments.trajectory)
    check_report_folder(arguments.report, "estimate --report", "surefoot.estimate.report")
    description = chosen_robot(arguments, default="go1")
    assert description is not None  # not None, because a default robot is given
    gains = read_gains(arguments.gains, description)
    log = read_log(arguments.log)
    result = run_estimator(build_robot(description), log, gains, progress_bar())
    summary = summarise(result)
    write_json(arguments.json, summary)
    if arguments.trajectory is not None:
        write_trajectory(arguments.trajectory, result)
    if arguments.report is not None:
        from surefoot.estimate.report import write_report

        page = write_report(result, summary, arguments.report, ["surefoot", *arguments.argv])
    if arguments.json != "-":
        print(summary_text(summary))
        if arguments.report is not None:
            print(f"  report    {page}")
