"""Options of surefoot walk."""

from __future__ import annotations

import argparse

from surefoot.cli.simulation_options import add_flaw_options, add_plant_options, add_tick_options

_VELOCITY_HELP = (
    "VX,VY,YAW_RATE@TIME: velocity of the centre of mass forward and to the left [m/s], turn to "
    "the left [rad/s]; s. In force until the next one; 0 before the first one. The controller "
    "clamps it to the robot's limits. Example: 0.5,0,0@1, 0,0,1.5@5. Repeatable"
)
_EPILOG = (
    "exit status: 0 the robot walked or stood, 3 it fell (results are written in both cases), 1 a "
    "file could not be written, 2 a wrong argument, 130 interrupted"
)


def add_walk_options(parser: argparse.ArgumentParser) -> None:
    """Add every option of surefoot walk."""
    parser.epilog = _EPILOG
    plant = add_plant_options(parser)
    plant.add_argument(
        "--slope-heading",
        type=float,
        metavar="DEG",
        help="direction of ascent, if --slope does not give it (0)",
    )
    plant.add_argument(
        "--rigid-soles", action="store_true", help="feet with rigid soles instead of soft ones"
    )
    _add_terrain_options(plant)
    add_flaw_options(parser).add_argument(
        "--lost-frames",
        type=float,
        default=0.0,
        metavar="PERCENT",
        help="share of LowStates and of LowCmds lost (0)",
    )
    controller = add_tick_options(parser)
    controller.add_argument(
        "--velocity", action="append", default=[], metavar="VELOCITY", help=_VELOCITY_HELP
    )
    controller.add_argument(
        "--gait",
        default="auto",
        metavar="auto|trot|walk",
        help="auto: stand at velocity 0, trot otherwise; trot: trot always; walk: stand at "
        "velocity 0, step with one foot at a time otherwise (auto)",
    )
    add = parser.add_argument_group("results").add_argument
    add("--json", metavar="FILE|-", help="write the summary as one JSON object; - is stdout")
    add("--report", metavar="DIR", help="write film, plots, index.html and summary.json")


def _add_terrain_options(group: argparse._ArgumentGroup) -> None:
    """Add the options of the terrain, of which only one may be given."""
    group.add_argument(
        "--step",
        default="0",
        metavar="HEIGHT[:HEADING]",
        help="platform ahead, up and down again; m, edges turned by degrees to the left (0)",
    )
    group.add_argument(
        "--stairs", default="0", metavar="HEIGHT:TREAD", help="five steps up and down; m, m (0)"
    )
    group.add_argument(
        "--blocks",
        type=float,
        default=0.0,
        metavar="HEIGHT",
        help="blocks ahead, random heights up to this one; m (0)",
    )
