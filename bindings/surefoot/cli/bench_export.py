"""surefoot bench --export: writes the QPs of recorded runs to files."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from surefoot.cli.bench_options import requested_forms
from surefoot.cli.missing_module import missing_module
from surefoot.cli.robot_choice import chosen_robot


def bench_export(arguments: argparse.Namespace) -> None:
    """Record scenarios and write their QPs; raise Error for a wrong argument."""
    try:
        from surefoot.bench.problems import export_qpbenchmark, record_problems
        from surefoot.bench.problems.record import SCENARIO_NAMES
    except ModuleNotFoundError as problem:
        raise missing_module("bench", problem) from None
    robot = chosen_robot(arguments, default="go1")
    assert robot is not None  # not None, because a default robot is given
    folder = Path(arguments.export)
    forms = requested_forms(arguments)
    for scenario in arguments.scenario or SCENARIO_NAMES:
        for form in forms:
            sequences = record_problems(robot, scenario, form)
            if arguments.qpbenchmark:
                export_qpbenchmark(sequences, folder)
            else:
                for sequence in sequences:
                    sequence.save(folder)
            count = sum(map(len, sequences))
            line = f"{scenario}, {form.name.lower()}: {count} QPs"
            print(line, file=sys.stderr, flush=True)
