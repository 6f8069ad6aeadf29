"""surefoot bench --solvers: compares QP solvers on recorded QPs."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from surefoot.cli.bench_options import requested_forms
from surefoot.cli.missing_module import missing_module
from surefoot.cli.output_files import check_json_path, write_json

if TYPE_CHECKING:
    from surefoot.bench.problems import QpSequence

SCENARIOS = ("quiet", "push80", "weak", "limp")


def bench_solvers(arguments: argparse.Namespace) -> None:
    """Record or read QPs, run every solver on these QPs, print tables and write JSON.

    Raises:
        Error: A wrong argument, or CMake or the sources are missing.
    """
    try:
        from surefoot.bench.problems import check_scenario
        from surefoot.bench.solvers import run_solvers, solvers_text
    except ModuleNotFoundError as problem:
        raise missing_module("bench", problem) from None
    check_json_path(arguments.json)
    for scenario in arguments.scenario or ():
        check_scenario(scenario)  # report a wrong name before the solver adapters are compiled
    requested_forms(arguments)
    result = run_solvers(_sequences(arguments))
    write_json(arguments.json, result)
    if arguments.json != "-":
        print(solvers_text(result))


def _sequences(arguments: argparse.Namespace) -> Iterator[QpSequence]:
    from surefoot.bench.problems import load_sequence, record_problems

    for path in arguments.solvers:
        yield load_sequence(Path(path))
    if arguments.solvers:
        return
    for scenario in arguments.scenario or SCENARIOS:
        for form in requested_forms(arguments):
            yield from record_problems(arguments.robot or "go1", scenario, form)
