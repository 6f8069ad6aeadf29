"""Which options of surefoot bench go together."""

from __future__ import annotations

import argparse

from surefoot._core import Error, Form
from surefoot.cli.stand import read_form

# What each way of running it has no use for.
_USELESS = {
    "--export": ("--solvers", "--ticks", "--peers", "--json", "--report"),
    "--solvers": ("--ticks", "--peers", "--report", "--urdf", "--config", "--qpbenchmark"),
    "--solvers FILE.npz": ("--robot", "--scenario", "--form"),
    "bench": ("--qpbenchmark",),
}


def check_options(arguments: argparse.Namespace) -> None:
    """Raise Error of an option that would have no effect."""
    ways = ["bench"]
    if arguments.export is not None:
        ways = ["--export"]
    elif arguments.solvers is not None:
        ways = ["--solvers", "--solvers FILE.npz"] if arguments.solvers else ["--solvers"]
    for way in ways:
        for option in _USELESS[way]:
            if _is_given(arguments, option):
                raise Error(f"{option}: has no effect with {_name(way)}")


def asked_forms(arguments: argparse.Namespace) -> tuple[Form, ...]:
    """Return the form of --form; both, if it is auto."""
    form = read_form(arguments.form)
    return (Form.CONDENSED, Form.GENERAL) if form == Form.AUTO else (form,)


def _name(way: str) -> str:
    return "bench alone, expected --export DIR too" if way == "bench" else way


def _is_given(arguments: argparse.Namespace, option: str) -> bool:
    value = getattr(arguments, option.removeprefix("--"))
    return value is not None and value is not False and value != "auto"
