"""surefoot faults: its options, the fault injection and the output of its results."""

from __future__ import annotations

import argparse
import os
import shlex
import sys
import textwrap
from pathlib import Path
from typing import TYPE_CHECKING

from surefoot._core import fault_table
from surefoot.cli.graphics import choose_graphics
from surefoot.cli.missing_module import missing_module
from surefoot.cli.output_files import (
    check_json_path,
    check_output_path,
    check_report_folder,
    write_json,
)
from surefoot.cli.progress import progress_bar, report_kept_results
from surefoot.cli.robot_choice import add_robot_options, chosen_robot

if TYPE_CHECKING:
    from surefoot.faults import FaultSettings

FAILED = 4  # exit status if a cell failed
_EPILOG = """\
Injects every fault of the catalogue (off, stuck, garbage, wrong, slow, delayed or intermittent,
where applicable) while the robot lies, rises, stands, is pushed and walks, with real sensors at 500
Hz. A cell is one fault injected in one mode. It passes if all commands are finite and within the
torque, rate and power limits, and if the reaction of fault_table() occurs within its detection
time.

With --store, an interrupted run can be resumed.

exit status: 0 every cell passed, 4 some failed, 1 a file could not be written, 2 a wrong argument
or store, 130 interrupted"""


def add_faults_options(parser: argparse.ArgumentParser) -> None:
    """Add every option of surefoot faults."""
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = _EPILOG
    add_robot_options(parser, "go1")
    add = parser.add_argument
    add(
        "--seed",
        type=int,
        default=0,
        metavar="N",
        help="seed of sensors, motors and lying pose (0)",
    )
    add("--jobs", type=int, metavar="N", help="number of processes (one per core)")
    add(
        "--only",
        action="append",
        default=[],
        metavar="PATTERN",
        help="run only this fault, or ROW/INJECTION/MODE with * and ?; repeatable",
    )
    add("--store", metavar="FILE", help="keep the result of every cell, to resume the run")
    add(
        "--taken-over",
        action="store_true",
        help="start with a standing robot, as surefoot run without --rise does",
    )
    add(
        "--list",
        action="store_true",
        help="list the cells and their expected reactions; run nothing",
    )
    add(
        "--names",
        action="store_true",
        help="list every fault that is reported to an operator: reaction, detection time, what "
        "clears it, meaning; run nothing",
    )
    add("--json", metavar="FILE|-", help="write the result as one JSON object; - is stdout")
    add("--report", metavar="DIR", help="write index.html, plots and summary.json")


def faults(arguments: argparse.Namespace) -> int | None:
    """Run the fault matrix, print the result and write the requested files.

    Returns:
        Exit status: 4 if a cell failed, else None.

    Raises:
        Error: A wrong argument.
        OSError: A file could not be written.
    """
    if arguments.names:
        print(fault_names_text())
        return None
    choose_graphics(pictures=False)
    check_json_path(arguments.json)
    check_output_path("--store", arguments.store)
    check_report_folder(arguments.report, "faults", "surefoot.faults.matrix.matrix_report")
    try:
        from surefoot.faults import choose_cells, faults_text, list_text, run_faults
    except ModuleNotFoundError as problem:
        raise missing_module("faults", problem) from None
    settings, bar = _settings(arguments), progress_bar()
    if arguments.list:
        print(list_text(choose_cells(settings.only, settings.taken_over)))
        return None
    with report_kept_results(arguments.store):
        result = run_faults(settings, None if bar is None else lambda n, of: bar("faults", n, of))
    command = shlex.join(["surefoot", *arguments.argv])
    result = {"command": command, **result}
    write_json(arguments.json, result)
    if arguments.report is not None:
        from surefoot.faults.matrix.matrix_report import write_faults_report

        page = write_faults_report(result, Path(arguments.report), command)
        print(f"report {page}", file=sys.stderr)
    if arguments.json != "-":
        print(faults_text(result))
    return FAILED if result["failed"] else None


def fault_names_text() -> str:
    """Return fault_table() as a text table for an operator."""
    blocks = []
    for info in fault_table():
        reaction = f"{info.reaction.name.lower()} within {1000 * info.detection_time:.0f} ms"
        head = f"{info.name:<18} {reaction}; clears: {info.cleared_by}"
        text = info.meaning
        if info.while_stepping:
            text += f". While the feet step: {info.while_stepping}"
        blocks += [head, textwrap.indent(textwrap.fill(text, 88), "    ")]
    return "\n".join(blocks)


def _settings(arguments: argparse.Namespace) -> FaultSettings:
    from surefoot.faults import FaultSettings
    from surefoot.faults.matrix.matrix_settings import MAX_JOBS

    robot = chosen_robot(arguments, default="go1")
    assert robot is not None  # not None, because a default robot is given
    jobs = arguments.jobs if arguments.jobs is not None else min(os.cpu_count() or 1, MAX_JOBS)
    only, taken_over = tuple(arguments.only), arguments.taken_over
    return FaultSettings(robot, arguments.seed, jobs, only, arguments.store, taken_over)
