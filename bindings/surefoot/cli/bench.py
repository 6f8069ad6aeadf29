"""surefoot bench: measures the computation time of a tick."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from surefoot.cli.bench_export import bench_export
from surefoot.cli.bench_options import check_options
from surefoot.cli.bench_solvers import bench_solvers
from surefoot.cli.graphics import choose_graphics
from surefoot.cli.missing_module import missing_module
from surefoot.cli.output_files import check_json_path, write_json
from surefoot.cli.robot_choice import add_robot_options, chosen_robot
from surefoot.cli.simulation_arguments import read_form
from surefoot.cli.simulation_options import add_form_option


def add_bench_options(parser: argparse.ArgumentParser) -> None:
    """Add every option of surefoot bench."""
    add_robot_options(parser, "go1")
    add = parser.add_argument
    add("--ticks", type=int, metavar="N", help="ticks to time in each scenario (20000)")
    add(
        "--scenario",
        action="append",
        metavar="NAME",
        help="scenario to time; repeatable (the default seven)",
    )
    add_form_option(parser)
    add(
        "--peers",
        action="store_true",
        help="also time whole ticks of TSID and PlaCo; installs them in .venv-peers",
    )
    add("--json", metavar="FILE|-", help="write the results as JSON; - is stdout")
    add("--report", metavar="DIR", help="write a page with histograms and tail latencies")
    add(
        "--solvers",
        nargs="*",
        metavar="FILE.npz",
        help="compare QP solvers instead, on these recorded QPs or on newly recorded ones",
    )
    add(
        "--export",
        metavar="DIR",
        help="write the QPs of all scenarios as .npz sequences; time nothing",
    )
    add("--qpbenchmark", action="store_true", help="with --export: write a sample for qpbenchmark")


def bench(arguments: argparse.Namespace) -> None:
    """Record runs, time their replay, print a table and write JSON.

    Raises:
        Error: A wrong argument.
    """
    choose_graphics(pictures=False)
    check_options(arguments)
    if arguments.solvers is not None:
        return bench_solvers(arguments)
    if arguments.export is not None:
        return bench_export(arguments)
    try:
        from surefoot.bench import BenchSettings, bench_text, run_bench, write_bench_report
        from surefoot.bench.peers import PeerOptions, add_peers, peers_text
        from surefoot.bench.settings import DEFAULT_SCENARIOS, DEFAULT_TICKS
    except ModuleNotFoundError as problem:
        raise missing_module("bench", problem) from None
    robot = chosen_robot(arguments, default="go1")
    assert robot is not None  # not None, because a default robot is given
    scenarios = tuple(arguments.scenario or DEFAULT_SCENARIOS)
    form = read_form(arguments.form)
    ticks = DEFAULT_TICKS if arguments.ticks is None else arguments.ticks
    settings = BenchSettings(robot, ticks, form, scenarios=scenarios)
    check_json_path(arguments.json)
    result = run_bench(settings, _print_progress)
    if arguments.peers:
        add_peers(result, settings, PeerOptions(urdf=robot.urdf, report_progress=_print_progress))
    write_json(arguments.json, result.figures)
    if arguments.report is not None:
        command = ["surefoot", *arguments.argv]
        _print_progress(f"report {write_bench_report(result, Path(arguments.report), command)}")
    if arguments.json != "-":
        print(bench_text(result.figures))
        if arguments.peers:
            print("\n" + peers_text(result.figures["peers"]))


def _print_progress(line: str) -> None:
    print(line, file=sys.stderr, flush=True)
