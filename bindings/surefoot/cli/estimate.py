"""surefoot estimate: runs the state estimator on a log and writes its results."""

from __future__ import annotations

import argparse
import sys

from surefoot._core import Error
from surefoot.cli.output_files import (
    check_json_path,
    check_report_folder,
    check_table_path,
    write_json,
)
from surefoot.cli.progress import progress_bar
from surefoot.cli.robot_choice import chosen_robot
from surefoot.cli.simulation_arguments import read_gains
from surefoot.estimate import (
    read_log,
    run_estimator,
    summarise,
    with_baselines,
    write_trajectory,
)
from surefoot.estimate.baselines.vqf_attitude import check_vqf
from surefoot.estimate.summary_text import summary_text
from surefoot.robot.loading import build_robot
from surefoot.sensor_log.file_checks import printable_path


def estimate(arguments: argparse.Namespace) -> None:
    """Read the log, run the estimator, print a summary and write the requested files.

    What the reader converted or left out is printed on stderr, one line each.

    Raises:
        Error: A wrong argument, an invalid log, or a log without any usable row. In the last case
            the files are written: they show the status of each row.
        OSError: A file could not be written.
    """
    check_json_path(arguments.json)
    check_table_path("--trajectory", arguments.trajectory)
    check_report_folder(arguments.report, "estimate --report", "surefoot.estimate.report")
    if arguments.baseline:
        check_vqf()
    description = chosen_robot(arguments, default="go1")
    assert description is not None  # not None, because a default robot is given
    gains = read_gains(arguments.gains, description)
    log = read_log(arguments.log, arguments.columns)
    for note in log.notes:
        print(f"surefoot: note: {log.source}: {note}", file=sys.stderr)
    result = run_estimator(build_robot(description), log, gains, progress_bar())
    if arguments.baseline:
        result = with_baselines(result)
    summary = summarise(result)
    write_json(arguments.json, summary)
    if arguments.trajectory is not None:
        write_trajectory(arguments.trajectory, result)
    if arguments.report is not None:
        from surefoot.estimate.report import write_report

        words = ["surefoot", *map(printable_path, arguments.argv)]
        page = write_report(result, summary, arguments.report, words)
    if arguments.json != "-":
        print(summary_text(summary))
        if arguments.report is not None:
            print(f"  report    {page}")
    if not summary["statuses"].get("OK"):
        statuses = ", ".join(f"{count} {name}" for name, count in summary["statuses"].items())
        raise Error(
            f"{log.source}: got no usable row of {log.rows} ({statuses or 'no time'}), expected "
            "rows that the estimator accepts"
        )
