"""surefoot tune search: the options, and the search."""

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
from surefoot.cli.environment import (
    check_json_path,
    check_output_path,
    check_report_folder,
    choose_graphics,
    missing_module,
    write_json,
)
from surefoot.cli.robot_choice import add_robot_options, chosen_robot
from surefoot.robot.gain_files import load_gains, save_gains
from surefoot.robot.loading import build_robot

if TYPE_CHECKING:
    from surefoot.tune.search.settings import SearchSettings

_EPILOG = """\
Every trial is judged by the same runs (seeds of sensors, motors, payload, ground and three pushes
each); the result is judged by others. Without --gain frequency and damping of five tasks are
searched: sway, height, tilt, yaw, foot, as sway_frequency and so on. With --store a search that
was ended, however, goes on where it was.

exit status: 0 done, 1 a file could not be written (trials in the store are safe), 2 a wrong
argument, store or cluster, 130 interrupted"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add every option of surefoot tune search."""
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = _EPILOG
    add_robot_options(parser, "go1")
    add = parser.add_argument
    add("--from", dest="start", metavar="FILE.toml", help="gains to start from (the robot's own)")
    add("--trials", type=int, default=200, metavar="N", help="in all, those in the store too (200)")
    add("--jobs", type=int, metavar="N", help="processes (one a core)")
    add("--cluster", metavar="tcp://HOST:PORT", help="Dask scheduler, instead of processes")
    add(
        "--objective",
        default="balance",
        metavar="NAME[,NAME]",
        help="balance, quiet, power; two for a Pareto front (balance)",
    )
    add(
        "--gain",
        action="append",
        metavar="NAME[=LOW:HIGH]",
        help="search this, a task's number or any gain; may be given again",
    )
    add("--episodes", type=int, default=6, metavar="N", help="runs a trial (6)")
    add("--held-out", type=int, default=10, metavar="N", help="runs that judge the result (10)")
    add("--sampler", metavar="NAME", help="cmaes, tpe, nsga2, random (cmaes; nsga2 for two)")
    add("--seed", type=int, default=0, metavar="N", help="of the search (0)")
    add("--store", metavar="FILE", help="journal of trials; a search in it goes on")
    add("--toml", metavar="FILE.toml", help="write the best gains")
    add("--report", metavar="DIR", help="write plots, films, gains.toml, index.html, summary.json")
    add("--json", metavar="FILE|-", help="write the result as one JSON object; - is stdout")


def run(arguments: argparse.Namespace) -> None:
    """Search, and print and write what was asked for.

    Raises:
        Error: A wrong argument, store or cluster.
        OSError: A file could not be written.
    """
    choose_graphics()
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
        where = f"in {arguments.store}: the same command goes on"
        kept = where if arguments.store else "lost; --store FILE would have kept them"
        print(f"surefoot: the trials that were done are {kept}", file=sys.stderr)
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
    from surefoot.tune.search.space import default_space, parse_parameter

    start = own if arguments.start is None else load_gains(arguments.start, own)
    robot: str | tuple[str, str] = arguments.robot or "go1"
    if arguments.urdf is not None:
        robot = (str(Path(arguments.urdf).resolve()), str(Path(arguments.config).resolve()))
    names = arguments.gain
    space = [parse_parameter(name) for name in names] if names else default_space()
    return SearchSettings(
        robot,
        start,
        trials=arguments.trials,
        jobs=arguments.jobs or min(os.cpu_count() or 1, MAX_JOBS),
        cluster=arguments.cluster,
        objectives=tuple(arguments.objective.split(",")),
        space=tuple(space),
        episodes=arguments.episodes,
        held_out=arguments.held_out,
        sampler=arguments.sampler,
        seed=arguments.seed,
        store=arguments.store,
    )


def _progress() -> Callable[[int, int, float], None] | None:
    """Return what draws a bar with the best cost on a terminal, or None."""
    if not sys.stderr.isatty():
        return None

    def draw(done: int, total: int, best: float) -> None:
        bar = ("#" * (30 * done // total)).ljust(30, ".")
        end = "\r\033[K" if done >= total else ""
        sys.stderr.write(f"\rsearch {bar} {done:4d} of {total}, best {best:.2f} {end}")
        sys.stderr.flush()

    return draw
