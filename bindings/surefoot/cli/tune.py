"""surefoot tune: three ways to gains, each a subcommand of its own."""

from __future__ import annotations

import argparse

from surefoot.cli import tune_design, tune_live, tune_search

_WAYS = (
    ("live", tune_live, "serve a page with sliders over a simulated robot, or one on UDP"),
    ("search", tune_search, "search gains over simulated disturbances, on every core"),
    ("design", tune_design, "compute gains and margins from frequencies, damping and delay"),
)


def add_tune_options(parser: argparse.ArgumentParser) -> None:
    """Add the subcommands of surefoot tune."""
    ways = parser.add_subparsers(metavar="WAY", required=True)
    for name, way, text in _WAYS:
        command = ways.add_parser(
            name, help=text, description=text[0].upper() + text[1:] + ".", allow_abbrev=False
        )
        command.set_defaults(run=way.run)
        way.add_options(command)
