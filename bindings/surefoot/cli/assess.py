"""surefoot assess: its options, the assessment and the output of its results."""

from __future__ import annotations

import argparse
import os
import shlex
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from surefoot.cli.graphics import choose_graphics
from surefoot.cli.missing_module import missing_module
from surefoot.cli.output_files import (
    check_json_path,
    check_output_path,
    check_report_folder,
    write_json,
)
from surefoot.cli.progress import progress_bar, report_kept_results
from surefoot.cli.robot_choice import (
    add_mjcf_option,
    add_robot_options,
    chosen_robot,
    print_mapping,
    robot_source,
)
from surefoot.robot.gain_files import gain_values, load_gains
from surefoot.robot.loading import build_robot

if TYPE_CHECKING:
    from surefoot.assess import AssessSettings

_EPILOG = """\
Pushes the robot in all directions, then varies ground, payload, link and motors, with real sensors
at 500 Hz and many seeds. With --walk it assesses a controller that walks: velocities, pushes while
it walks, and conditions. With --mjcf, pushes and stands, or walks, are repeated on the robot of an
MJCF; the scorecard has a section for them. Impulses are compared with the LIP push limit (linear
inverted pendulum) and with the push limit of the robot. With --store, an interrupted assessment can
be resumed.

exit status: 0 done, 1 a file could not be written (results in the store are kept), 2 a wrong
argument, scenario or store, 130 interrupted"""


def add_assess_options(parser: argparse.ArgumentParser) -> None:
    """Add every option of surefoot assess."""
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = _EPILOG
    add_robot_options(parser, "go1")
    add_mjcf_option(parser)
    add = parser.add_argument
    add(
        "--controller",
        default="surefoot",
        metavar="NAME|MODULE:CALLABLE",
        help="controller under test: surefoot, pd, force_qp (with --walk: surefoot, raibert), or a "
        "callable that receives the surefoot.Robot and returns a function from LowState to LowCmd, "
        "or with --walk an object with set_velocity() and update() (surefoot)",
    )
    add("--walk", action="store_true", help="assess walking instead of standing")
    add("--gains", metavar="FILE.toml", help="gains of the controller surefoot (the robot's own)")
    add(
        "--quick",
        action="store_true",
        help="one push duration; the worst of three seeds counts: minutes",
    )
    add("--scenario", metavar="FILE.toml", help="your own scorecard instead of the full one")
    add("--jobs", type=int, metavar="N", help="number of processes (one per core)")
    add(
        "--deadline",
        type=float,
        default=60.0,
        metavar="S",
        help="wall time limit of one run; a controller that takes longer counts as hung (60)",
    )
    add("--store", metavar="FILE", help="keep results, one per line; resume the assessment in FILE")
    add("--json", metavar="FILE|-", help="write the result as one JSON object; - is stdout")
    add("--report", metavar="DIR", help="write index.html, plots, films, tables and summary.json")


def assess(arguments: argparse.Namespace) -> None:
    """Run the assessment; print the result and write the requested files.

    Raises:
        Error: A wrong argument, scenario or store.
        OSError: A file could not be written.
    """
    choose_graphics(pictures=arguments.report is not None)
    check_json_path(arguments.json)
    check_output_path("--store", arguments.store)
    check_report_folder(arguments.report, "assess", "surefoot.assess.report")
    try:
        from surefoot.assess import assess_text, run_assess, walk_text

        settings = _settings(arguments)
    except ModuleNotFoundError as problem:
        raise missing_module("assess", problem) from None
    folder = None if arguments.report is None else Path(arguments.report)
    with report_kept_results(arguments.store):
        result = run_assess(settings, progress_bar(), folder)
    command = shlex.join(["surefoot", *arguments.argv])
    result = {"command": command, **result}
    write_json(arguments.json, result)
    if folder is not None:
        print(f"report {_write_report(arguments, result, folder, command)}", file=sys.stderr)
    if arguments.json != "-":
        print(walk_text(result) if arguments.walk else assess_text(result))


def _write_report(
    arguments: argparse.Namespace, result: dict[str, Any], folder: Path, command: str
) -> Path:
    if arguments.walk:
        from surefoot.assess.walking.walk_report import write_walk_report

        return write_walk_report(result, folder, command)
    from surefoot.assess.report import write_assess_report

    return write_assess_report(result, folder, command)


def _settings(arguments: argparse.Namespace) -> AssessSettings:
    from surefoot._core import Error
    from surefoot.assess import (
        AssessSettings,
        ControllerUnderTest,
        read_scorecard,
        read_walk_scorecard,
        standard_scorecard,
        standard_walk_scorecard,
    )
    from surefoot.assess.settings import MAX_JOBS

    description = chosen_robot(arguments, default="go1")
    assert description is not None  # not None, because a default robot is given
    print_mapping(description)
    robot = robot_source(arguments, default="go1")
    gains: dict[str, float] = {}
    if arguments.gains is not None:
        if arguments.controller != "surefoot":
            raise Error(f"--gains: got controller '{arguments.controller}', expected surefoot")
        own = build_robot(description).config.gains
        gains = gain_values(load_gains(arguments.gains, own))
    if arguments.scenario is not None and arguments.quick:
        raise Error("--scenario: got --quick too, expected one of them")
    read, standard = (
        (read_walk_scorecard, standard_walk_scorecard)
        if arguments.walk
        else (read_scorecard, standard_scorecard)
    )
    if arguments.scenario is not None:
        card = read(Path(arguments.scenario))
    else:
        card = standard("quick" if arguments.quick else "full")
    return AssessSettings(
        robot,
        ControllerUnderTest(arguments.controller, gains, walks=arguments.walk),
        card,
        arguments.jobs if arguments.jobs is not None else min(os.cpu_count() or 1, MAX_JOBS),
        arguments.deadline,
        arguments.store,
        None if arguments.mjcf is None else str(Path(arguments.mjcf).resolve()),
    )
