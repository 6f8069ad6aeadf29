"""surefoot stand: simulates a standing robot and writes the results."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from surefoot.cli.graphics import choose_graphics
from surefoot.cli.missing_module import missing_module
from surefoot.cli.output_files import (
    check_json_path,
    check_report_folder,
    check_table_path,
)
from surefoot.cli.progress import progress_bar
from surefoot.cli.simulation_arguments import read_simulation
from surefoot.cli.simulation_output import write_outputs
from surefoot.estimate import write_log
from surefoot.replay import recording_columns

if TYPE_CHECKING:
    from surefoot.stand import StandSettings


REPORT_MODULE = "surefoot.stand.report"


def stand(arguments: argparse.Namespace) -> int:
    """Simulate the robot, print a summary and write the requested files.

    Returns:
        Exit status: 0 if the robot stood, 3 if the robot fell.

    Raises:
        Error: A wrong argument.
    """
    choose_graphics(pictures=arguments.report is not None)
    try:
        from surefoot.stand import SensorRecorder, run_stand, stand_recording, summarise
        from surefoot.stand.summary_text import summary_text
    except ModuleNotFoundError as problem:
        raise missing_module("stand", problem) from None
    settings = read_settings(arguments)
    check_json_path(arguments.json)
    check_table_path("--log", arguments.log)
    check_report_folder(arguments.report, "stand", REPORT_MODULE)
    progress = progress_bar()
    sensors = None if arguments.log is None else SensorRecorder()
    log = run_stand(settings, progress, sensors)
    if sensors is not None:
        write_log(arguments.log, sensors.log(), recording_columns(stand_recording(log, sensors)))
    return write_outputs(arguments, log, summarise(log), summary_text, REPORT_MODULE, progress)


def read_settings(arguments: argparse.Namespace) -> StandSettings:
    """Return the settings that the arguments give; raise Error if an argument is wrong."""
    from surefoot.stand import StandSettings

    return StandSettings(**read_simulation(arguments))
