"""surefoot tune search: searches gains by simulation."""

from __future__ import annotations

import argparse
import os
import shlex
import sys
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from surefoot._core import Gains
from surefoot.cli.graphics import choose_graphics
from surefoot.cli.missing_module import missing_module
from surefoot.cli.output_files import (
    check_json_path,
    check_output_path,
    check_report_folder,
    write_json,
)
from surefoot.cli.robot_choice import add_robot_options, chosen_robot, robot_source
from surefoot.robot.gain_files import load_gains, save_gains
from surefoot.robot.loading import build_robot

if TYPE_CHECKING:
    from surefoot.tune.search.settings import SearchSettings

_EPILOG = """\
Every trial is evaluated on the same runs (random sensors, motors, payload and ground, three pushes
each); the result is evaluated on held-out runs. Without --gain, the search varies frequency and
damping of five tasks: sway, height, tilt, yaw and foot, named sway_frequency and so on. With
--walk, every run is a walk (a turn, sideways, forward, two pushes, a stop), and the search varies
gait and swing. With --store, an interrupted search can be resumed.

exit status: 0 done, 1 a file could not be written (trials in the store are kept), 2 a wrong
argument, store or cluster, 130 interrupted"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add every option of surefoot tune search."""
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = _EPILOG
    add_robot_options(parser, "go1")
    add = parser.add_argument
    add("--from", dest="start", metavar="FILE.toml", help="gains to start from (the robot's own)")
    add(
        "--trials",
        type=int,
        default=200,
        metavar="N",
        help="total number of trials, including those in the store (200)",
    )
    add("--jobs", type=int, metavar="N", help="number of processes (one per core)")
    add("--cluster", metavar="tcp://HOST:PORT", help="Dask scheduler instead of local processes")
    add("--walk", action="store_true", help="search the gains of walking instead of standing")
    add(
        "--objective",
        metavar="NAME[,NAME]",
        help="balance, quiet, power; with --walk: walk, pushes, transport; two for a Pareto front "
        "(balance; walk)",
    )
    add(
        "--gain",
        action="append",
        metavar="NAME[=LOW:HIGH]",
        help="search this parameter: a task's frequency or damping, or any gain; repeatable",
    )
    add("--episodes", type=int, default=6, metavar="N", help="runs per trial (6)")
    add(
        "--held-out",
        type=int,
        default=10,
        metavar="N",
        help="held-out runs that evaluate the result (10)",
    )
    add("--sampler", metavar="NAME", help="cmaes, tpe, nsga2, random (cmaes; nsga2 for two)")
    add("--seed", type=int, default=0, metavar="N", help="seed of the search (0)")
    add("--store", metavar="FILE", help="journal of trials; resume the search in FILE")
    add("--toml", metavar="FILE.toml", help="write the best gains")
    add("--report", metavar="DIR", help="write plots, films, gains.toml, index.html, summary.json")
    add("--json", metavar="FILE|-", help="write the result as one JSON object; - is stdout")


def run(arguments: argparse.Namespace) -> None:
    """Search gains, print a summary and write the requested files.

    Raises:
        Error: A wrong argument, store or cluster.
        OSError: A file could not be written.
    """
    choose_graphics(pictures=arguments.report is not None)
    check_json_path(arguments.json)
    check_output_path("--toml", arguments.toml)
    check_output_path("--store", arguments.store)
    check_report_folder(arguments.report, "tune search", "surefoot.tune.search.report")
    warnings.filterwarnings("ignore", module="optuna")
    try:
        from surefoot.tune.search.run import run_search
        from surefoot.tune.search.summary import gains_provenance, summarise, summary_text
    except ModuleNotFoundError as problem:
        raise missing_module("tune search", problem, "tune") from None
    description = chosen_robot(arguments, default="go1")
    assert description is not None
    own = build_robot(description).config.gains
    try:
        result = run_search(_settings(arguments, own), own, _progress())
    except KeyboardInterrupt:
        where = f"in {arguments.store}: run the same command again to resume"
        kept = where if arguments.store else "lost; use --store FILE to keep them"
        print(f"surefoot: the finished trials are {kept}", file=sys.stderr)
        raise
    summary = summarise(result)
    command = shlex.join(["surefoot", *arguments.argv])
    write_json(arguments.json, summary)
    if arguments.toml is not None:
        name = summary["robot"] if isinstance(summary["robot"], str) else None
        save_gains(arguments.toml, result.best.gains, name, gains_provenance(summary, command))
    page = None
    if arguments.report is not None:
        from surefoot.tune.search.report import write_report

        page = write_report(result, summary, Path(arguments.report), command)
    if arguments.json != "-":
        print(summary_text(summary))
        if page is not None:
            print(f"  report    {page}")


def _settings(arguments: argparse.Namespace, own: Gains) -> SearchSettings:
    from surefoot.tune.search.settings import MAX_JOBS, SearchSettings
    from surefoot.tune.search.space import parse_parameter

    start = own if arguments.start is None else load_gains(arguments.start, own)
    robot = robot_source(arguments, default="go1")
    return SearchSettings(
        robot,
        start,
        trials=arguments.trials,
        jobs=arguments.jobs or min(os.cpu_count() or 1, MAX_JOBS),
        cluster=arguments.cluster,
        walk=arguments.walk,
        objectives=tuple(arguments.objective.split(",")) if arguments.objective else (),
        space=tuple(parse_parameter(name) for name in arguments.gain or ()),
        episodes=arguments.episodes,
        held_out=arguments.held_out,
        sampler=arguments.sampler,
        seed=arguments.seed,
        store=arguments.store,
    )


def _progress() -> Callable[[int, int, float], None] | None:
    """Return a function (done, total, best cost) that draws a bar on stderr.

    None: stderr is not a terminal.
    """
    if not sys.stderr.isatty():
        return None

    def draw(done: int, total: int, best: float) -> None:
        bar = ("#" * (30 * done // total)).ljust(30, ".")
        end = "\r\033[K" if done >= total else ""
        sys.stderr.write(f"\rsearch {bar} {done:4d} of {total}, best {best:.2f} {end}")
        sys.stderr.flush()

    return draw
