"""surefoot bench --solvers: QP solvers side by side on recorded programs."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from surefoot._core import Error, Form
from surefoot.cli.simulation import check_json_place, missing_module, write_json
from surefoot.cli.stand import read_form

if TYPE_CHECKING:
    from surefoot.bench.problems import Sequence

SCENARIOS = ("quiet", "push80", "weak", "limp")


def bench_solvers(arguments: argparse.Namespace) -> None:
    """Record programs or read them, run every solver, print tables and write JSON; raises Error."""
    try:
        from surefoot.bench.solvers import run_solvers, solvers_text
    except ModuleNotFoundError as problem:
        raise missing_module("bench", problem) from None
    check_json_place(arguments.json)
    result = run_solvers(_sequences(arguments))
    write_json(arguments.json, result)
    if arguments.json != "-":
        print(solvers_text(result))


def _sequences(arguments: argparse.Namespace) -> Iterator[Sequence]:
    from surefoot.bench.problems import load_sequence, record_problems

    for path in arguments.solvers:
        yield load_sequence(Path(path))
    if arguments.solvers:
        return
    if getattr(arguments, "urdf", None) is not None:
        raise Error("bench --solvers: got --urdf, expected a robot by name")
    form = read_form(arguments.form)
    forms = (Form.CONDENSED, Form.GENERAL) if form == Form.AUTO else (form,)
    for scenario in SCENARIOS:
        for each in forms:
            yield from record_problems(arguments.robot or "go1", scenario, each)
