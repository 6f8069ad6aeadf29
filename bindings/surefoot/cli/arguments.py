"""Parser of the command surefoot, with its subcommands and options."""

from __future__ import annotations

import argparse
import importlib.metadata
import re
from collections.abc import Callable, Sequence
from typing import Any, NoReturn

from surefoot.cli.assess import add_assess_options, assess
from surefoot.cli.bench import add_bench_options, bench
from surefoot.cli.doctor import add_doctor_options, doctor
from surefoot.cli.estimate import estimate
from surefoot.cli.estimate_options import add_estimate_options
from surefoot.cli.export import export
from surefoot.cli.faults import add_faults_options, faults
from surefoot.cli.replay import add_replay_options, replay
from surefoot.cli.robot_choice import add_file_options, add_robot_options
from surefoot.cli.robots_check import add_robots_options, robots
from surefoot.cli.run import run
from surefoot.cli.run_options import add_run_options
from surefoot.cli.stand import stand
from surefoot.cli.stand_options import add_stand_options
from surefoot.cli.tables import list_gains
from surefoot.cli.tune import add_tune_options
from surefoot.cli.virtual_robot import robot
from surefoot.cli.virtual_robot_options import add_virtual_robot_options
from surefoot.cli.walk import walk
from surefoot.cli.walk_options import add_walk_options
from surefoot.robot.robot_toml import suggest


class _Parser(argparse.ArgumentParser):
    """Argument parser that reports an error in one line."""

    def error(self, message: str) -> NoReturn:
        line = " ".join(message.split())
        self.exit(2, f"{self.prog}: error: {line} (see {self.prog} --help)\n")

    # argparse would report unknown options from the top-level parser, which does not know the
    # options of the subcommand. The subcommand's own parser can suggest the nearest option.
    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        found, unknown = super().parse_known_args(args, namespace)
        if unknown:
            options = [option for action in self._actions for option in action.option_strings]
            guess = suggest(unknown[0], options)
            self.error(f"unrecognized arguments: {' '.join(unknown)}{guess}")
        return found, unknown


def parse_arguments(argv: Sequence[str]) -> argparse.Namespace:
    """Parse the arguments of the command.

    Args:
        argv: Arguments without the program name.

    Returns:
        The parsed arguments; `run` is the function of the chosen subcommand.

    Raises:
        SystemExit: An argument is wrong (status 2, one line on stderr), or --help or --version
            was printed (status 0).
    """
    return build_parser().parse_args(_join_negative_values(argv))


def build_parser() -> argparse.ArgumentParser:
    """Return the parser of the command with all subcommands."""
    parser = _Parser(
        prog="surefoot",
        description="Whole-body torque control for Unitree quadrupeds.",
        allow_abbrev=False,
    )
    version = f"surefoot {importlib.metadata.version('surefoot')}"
    parser.add_argument("--version", action="version", version=version)
    commands = parser.add_subparsers(metavar="COMMAND", required=True)

    def add(name: str, run: Callable[[argparse.Namespace], int | None], text: str) -> _Parser:
        command: _Parser = commands.add_parser(
            name, help=text, description=text[0].upper() + text[1:] + ".", allow_abbrev=False
        )
        command.set_defaults(run=run)
        return command

    add_stand_options(add("stand", stand, "simulate a robot that stands under torque control"))
    add_walk_options(add("walk", walk, "simulate a robot that walks under torque control"))
    add_run_options(add("run", run, "control a robot over UDP with the SDK's frames"))
    text = "run the state estimator on a sensor log"
    add_estimate_options(add("estimate", estimate, text))
    text = "replay a log through a new controller and compare the commands bit for bit"
    add_replay_options(add("replay", replay, text))
    _add_export_options(
        add("export", export, "write a robot's model and gains to one file for its computer")
    )
    add_bench_options(add("bench", bench, "time the controller on recorded runs"))
    add_virtual_robot_options(
        add("robot", robot, "simulate a robot that SDK programs control over UDP")
    )
    text = "inject every fault of the catalogue in simulation and check the reactions"
    add_faults_options(add("faults", faults, text))
    text = (
        "measure a controller that stands or walks: pushes, ground, payload, link, motors, faults"
    )
    add_assess_options(add("assess", assess, text))
    tune = commands.add_parser(
        "tune", help="find gains", description="Find gains.", allow_abbrev=False
    )
    add_tune_options(tune)
    text = "list the robots known by name, or check a robot of your own"
    add_robots_options(add("robots", robots, text))
    gains = add("gains", list_gains, "list all gains: value, unit, range, meaning")
    add_robot_options(gains, "the library's default values")
    text = "check the installation and this computer, and say what to do"
    add_doctor_options(add("doctor", doctor, text))
    return parser


def _add_export_options(parser: _Parser) -> None:
    parser.add_argument("robot", nargs="?", metavar="ROBOT", help="see surefoot robots")
    parser.add_argument("file", metavar="FILE.robot", help="the file to write")
    add_file_options(parser, "ROBOT")


def _join_negative_values(argv: Sequence[str]) -> list[str]:
    """Return the arguments with '--slope' '-5:90' joined to '--slope=-5:90'.

    Otherwise argparse would parse '-5:90' as an option.
    """
    joined: list[str] = []
    for word in argv:
        if joined and re.match(r"--[a-z-]+$", joined[-1]) and re.match(r"-[\d.]", word):
            joined[-1] += "=" + word
        else:
            joined.append(word)
    return joined
