"""Output of a simulated run: JSON, report, summary, and the exit status of the command."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

from surefoot.cli.output_files import write_json

if TYPE_CHECKING:
    from surefoot.stand.simulation_log import SimulationLog
    from surefoot.stand.simulation_loop import Progress

FELL = 3  # exit status if the robot fell


def write_outputs(
    arguments: argparse.Namespace,
    log: SimulationLog,
    summary: dict[str, Any],
    summary_text: Callable[[dict[str, Any]], str],
    report_module: str,
    progress: Progress | None,
) -> int:
    """Write JSON and report as requested, print the summary, and return the exit status.

    Args:
        arguments: Arguments of the command: json, report, argv.
        log: Log of the run.
        summary: Summary of the run.
        summary_text: Function that returns the summary as text.
        report_module: Name of the module with write_report(); imported only for a report, because
            it needs the packages for plots.
        progress: Function that is called after every frame of the film.
    """
    write_json(arguments.json, summary)
    if arguments.report is not None:
        command = ["surefoot", *arguments.argv]
        write_report = import_module(report_module).write_report
        page = write_report(log, summary, Path(arguments.report), command, progress)
    if arguments.json != "-":
        print(summary_text(summary))
        if arguments.report is not None:
            print(f"  report    {page}")
    return FELL if log.fell else 0
