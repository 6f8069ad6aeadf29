"""Options of surefoot stand."""

from __future__ import annotations

import argparse

from surefoot.cli.simulation_options import add_flaw_options, add_plant_options, add_tick_options

_EPILOG = (
    "exit status: 0 the robot stood, 3 it fell (results are written in both cases), 1 a file could "
    "not be written, 2 a wrong argument, 130 interrupted"
)


def add_stand_options(parser: argparse.ArgumentParser) -> None:
    """Add every option of surefoot stand."""
    parser.epilog = _EPILOG
    add_plant_options(parser)
    add_flaw_options(parser)
    add_tick_options(parser)
    add = parser.add_argument_group("results").add_argument
    add("--json", metavar="FILE|-", help="write the summary as one JSON object; - is stdout")
    add(
        "--log",
        metavar="FILE.npz|FILE.csv",
        help="write the controller's inputs, and the true state in separate columns, for surefoot "
        "estimate and surefoot replay (npz only)",
    )
    add("--report", metavar="DIR", help="write film, plots, index.html and summary.json")
