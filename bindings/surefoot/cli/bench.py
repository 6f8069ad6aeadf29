"""surefoot bench: how long a tick takes."""

from __future__ import annotations

import argparse

from surefoot.cli.bench_solvers import bench_solvers
from surefoot.cli.robot_choice import chosen_robot
from surefoot.cli.simulation import check_json_place, choose_graphics, missing_module, write_json
from surefoot.cli.stand import read_form


def bench(arguments: argparse.Namespace) -> None:
    """Record a run, time its replay, print a table and write JSON; raises Error."""
    choose_graphics()
    if arguments.solvers is not None:
        return bench_solvers(arguments)
    try:
        from surefoot.bench import BenchSettings, bench_text, run_bench
    except ModuleNotFoundError as problem:
        raise missing_module("bench", problem) from None
    robot = chosen_robot(arguments, default="go1")
    assert robot is not None  # there is a default
    settings = BenchSettings(robot, arguments.ticks, read_form(arguments.form))
    check_json_place(arguments.json)
    result = run_bench(settings)
    write_json(arguments.json, result)
    if arguments.json != "-":
        print(bench_text(result))
