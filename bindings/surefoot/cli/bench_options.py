"""Checks which options of surefoot bench may be combined."""

from __future__ import annotations

import argparse

from surefoot._core import Error, QpForm
from surefoot.cli.simulation_arguments import read_form

# Options without effect, by form of the command.
_INEFFECTIVE_OPTIONS = {
    "--export": ("--solvers", "--ticks", "--peers", "--json", "--report"),
    "--solvers": ("--ticks", "--peers", "--report", "--urdf", "--config", "--qpbenchmark"),
    "--solvers FILE.npz": ("--robot", "--scenario", "--form"),
    "bench alone": ("--qpbenchmark",),
}


def check_options(arguments: argparse.Namespace) -> None:
    """Raise Error if an option would have no effect."""
    commands = ["bench alone"]
    if arguments.export is not None:
        commands = ["--export"]
    elif arguments.solvers is not None:
        commands = ["--solvers", "--solvers FILE.npz"] if arguments.solvers else ["--solvers"]
    remedy = "--export DIR too" if commands == ["bench alone"] else "the command without it"
    for command in commands:
        for option in _INEFFECTIVE_OPTIONS[command]:
            if _is_given(arguments, option):
                raise Error(f"{option}: has no effect with {command}, expected {remedy}")


def requested_forms(arguments: argparse.Namespace) -> tuple[QpForm, ...]:
    """Return the QP form that --form names as a tuple of one; both forms for "auto"."""
    form = read_form(arguments.form)
    return (QpForm.CONDENSED, QpForm.GENERAL) if form == QpForm.AUTO else (form,)


def _is_given(arguments: argparse.Namespace, option: str) -> bool:
    value = getattr(arguments, option.removeprefix("--"))
    return value is not None and value is not False and value != "auto"
