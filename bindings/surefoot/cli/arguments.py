"""What can be typed after surefoot, and how it is read."""

from __future__ import annotations

import argparse
import importlib.metadata
import re
from collections.abc import Callable, Sequence
from typing import NoReturn

from surefoot.cli.export import export
from surefoot.cli.stand import stand
from surefoot.cli.tables import list_gains, list_robots

_PUSH_HELP = (
    "DIRECTION:IMPULSE:LENGTH[:HEIGHT]@TIME: lateral, forward or degrees from forward towards "
    "left; N.s, or percent of what a linear inverted pendulum survives; s; m above the centre of "
    "mass (0); s. Example: lateral:8.0:0.1@2.0, lateral:50%%:0.1:-0.05@2.0. Repeat for more"
)


class _Parser(argparse.ArgumentParser):
    """A parser whose complaint is one line."""

    def error(self, message: str) -> NoReturn:
        line = " ".join(message.split())
        self.exit(2, f"{self.prog}: error: {line} (see {self.prog} --help)\n")


def parse_arguments(words: Sequence[str]) -> argparse.Namespace:
    """Read the arguments; `run` of what comes back is the subcommand's function.

    Exits with status 2 and one line on stderr if they make no sense.
    """
    return _build_parser().parse_args(_bind_negatives(words))


def _build_parser() -> _Parser:
    parser = _Parser(
        prog="surefoot",
        description="Whole-body torque control for Unitree quadrupeds.",
        allow_abbrev=False,
    )
    version = f"surefoot {importlib.metadata.version('surefoot')}"
    parser.add_argument("--version", action="version", version=version)
    commands = parser.add_subparsers(metavar="COMMAND", required=True)

    def add(name: str, run: Callable[[argparse.Namespace], None], text: str) -> _Parser:
        command: _Parser = commands.add_parser(
            name, help=text, description=text[0].upper() + text[1:] + ".", allow_abbrev=False
        )
        command.set_defaults(run=run)
        return command

    _add_stand_options(add("stand", stand, "let a robot stand on torques in simulation"))
    _add_export_options(add("export", export, "write the one file that a robot computer needs"))
    add("robots", list_robots, "list the robots known by name")
    gains = add("gains", list_gains, "list what can be tuned: value, unit, range, meaning")
    gains.add_argument("--robot", metavar="NAME", help="show this robot's values")
    return parser


def _add_stand_options(parser: _Parser) -> None:
    _add_plant_options(parser)
    _add_flaw_options(parser)
    add = parser.add_argument_group("controller and results").add_argument
    add("--gains", metavar="FILE.toml", help="gains that differ from the robot's own")
    add(
        "--motor-damping",
        type=float,
        default=0.0,
        metavar="KD",
        help="motor-side damping [N.m.s/rad] (0: pure torque mode)",
    )
    add("--json", metavar="FILE|-", help="write the summary as one JSON object; - is stdout")
    add("--report", metavar="DIR", help="write film, plots, index.html and summary.json")


def _add_plant_options(parser: _Parser) -> None:
    add = parser.add_argument_group("simulation").add_argument
    add("--robot", default="go1", metavar="NAME", help="see surefoot robots (go1)")
    add("--duration", type=float, default=10.0, metavar="S", help="[s] (10)")
    add("--rate", type=float, default=500.0, metavar="HZ", help="control rate [Hz] (500)")
    add("--sensors", default="real", metavar="real|ideal", help="with their flaws or none (real)")
    add(
        "--foot-force",
        metavar="est|raw|dead",
        help="which foot force field of LowState lives (as on the robot: dead on go1)",
    )
    add("--friction", type=float, default=0.8, metavar="MU", help="of the ground (0.8)")
    add("--slope", default="0", metavar="DEG[:HEADING]", help="steepness, direction of ascent (0)")
    add("--payload", default="0", metavar="KG[:X:Y:Z]", help="unknown mass, at x, y, z in m (0)")
    add("--push", action="append", default=[], metavar="PUSH", help=_PUSH_HELP)
    add("--seed", type=int, default=1, metavar="N", help="of every random number (1)")


def _add_flaw_options(parser: _Parser) -> None:
    """Add what makes the simulated robot another than the controller believes."""
    add = parser.add_argument_group("flaws of motors and ground").add_argument
    add("--delay-ms", type=float, default=0.0, metavar="MS", help="further delay of commands (0)")
    add("--motor-lag-ms", type=float, metavar="MS", help="time constant (real: 2, ideal: 0)")
    add("--armature-scale", type=float, default=1.0, metavar="F", help="on rotor inertia (1)")
    add(
        "--joint-friction-scale",
        type=float,
        default=1.0,
        metavar="F",
        help="on friction and damping of the joints (1)",
    )
    add("--backlash-deg", type=float, default=0.0, metavar="DEG", help="play of every gear (0)")
    add("--soft-ground", type=float, default=0.0, metavar="M", help="sink of standing feet [m] (0)")


def _add_export_options(parser: _Parser) -> None:
    parser.add_argument("robot", nargs="?", metavar="ROBOT", help="see surefoot robots")
    parser.add_argument("file", metavar="FILE.robot", help="the file to write")
    parser.add_argument("--urdf", metavar="FILE.urdf", help="instead of ROBOT, a robot of your own")
    parser.add_argument("--config", metavar="FILE.toml", help="what that URDF does not say")


def _bind_negatives(words: Sequence[str]) -> list[str]:
    """Join '--slope' '-5:90' to '--slope=-5:90', which argparse would take for an option."""
    bound: list[str] = []
    for word in words:
        if bound and re.match(r"--[a-z-]+$", bound[-1]) and re.match(r"-[\d.]", word):
            bound[-1] += "=" + word
        else:
            bound.append(word)
    return bound
