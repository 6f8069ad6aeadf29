"""surefoot tune: three methods to find gains, each a subcommand."""

from __future__ import annotations

import argparse

from surefoot.cli import tune_design, tune_live, tune_search

_SUBCOMMANDS = (
    ("live", tune_live, "serve a page with gain sliders for a simulated robot, or for one on UDP"),
    ("search", tune_search, "search gains by simulating disturbances on all cores"),
    ("design", tune_design, "compute gains and margins from frequencies, damping and delay"),
)


def add_tune_options(parser: argparse.ArgumentParser) -> None:
    """Add the subcommands of surefoot tune."""
    subparsers = parser.add_subparsers(metavar="WAY", required=True)
    for name, module, text in _SUBCOMMANDS:
        command = subparsers.add_parser(
            name, help=text, description=text[0].upper() + text[1:] + ".", allow_abbrev=False
        )
        command.set_defaults(run=module.run)
        module.add_options(command)
