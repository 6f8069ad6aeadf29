"""surefoot bench: how long a tick takes."""

from __future__ import annotations

import argparse
import sys

from surefoot.cli.robot_choice import chosen_robot
from surefoot.cli.simulation import check_json_place, choose_graphics, missing_module, write_json
from surefoot.cli.stand import read_form


def bench(arguments: argparse.Namespace) -> None:
    """Record a run, time its replay, print a table and write JSON; raises Error."""
    choose_graphics()
    try:
        from surefoot.bench import BenchSettings, bench_text, record, run_bench
        from surefoot.bench.peers import PeerOptions, add_peers, peers_text
    except ModuleNotFoundError as problem:
        raise missing_module("bench", problem) from None
    robot = chosen_robot(arguments, default="go1")
    assert robot is not None  # there is a default
    settings = BenchSettings(robot, arguments.ticks, read_form(arguments.form))
    check_json_place(arguments.json)
    result = run_bench(settings)
    if arguments.peers:
        options = PeerOptions(urdf=robot.urdf, say=lambda line: print(line, file=sys.stderr))
        add_peers(result, record(settings), options)
    write_json(arguments.json, result)
    if arguments.json != "-":
        print(bench_text(result))
        if arguments.peers:
            print("\n" + peers_text(result["peers"]))
