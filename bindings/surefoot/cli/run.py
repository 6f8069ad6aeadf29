"""surefoot run: the stand controller on a robot that speaks the SDK's UDP frames."""

from __future__ import annotations

import argparse
import math
import select
import signal
import sys
import threading
import time
from collections.abc import Callable
from typing import TextIO

from surefoot._core import RunOptions, RunSnapshot, StandOptions, StandRunner
from surefoot.cli.robot_choice import chosen_robot
from surefoot.cli.run_text import (
    Notices,
    closing_text,
    no_robot_text,
    run_summary,
    status_line,
    why_damped,
)
from surefoot.cli.simulation import check_json_place, write_json
from surefoot.cli.stand import read_form, read_gains
from surefoot.protocol import default_generation
from surefoot.robots import build_robot

ENDED_DAMPED = 3
NO_ROBOT = 1
_LOOK = 0.02  # [s] between looks at the loop
_LINE = 1.0  # [s] between status lines


def run(arguments: argparse.Namespace) -> int:
    """Control the robot until it is told to stop; print, and write JSON; raises Error.

    Returns:
        Exit status: 0 it stood to the end, 1 no robot of the right generation answered, 3 it ended
        damped.
    """
    check_json_place(arguments.json)
    runner, generation = _make_runner(arguments)
    out = sys.stderr if arguments.json == "-" else sys.stdout
    print(
        f"{arguments.host}:{arguments.port} from port {runner.local_port}, {generation}, "
        f"{arguments.rate:g} Hz, power level {arguments.power_level}; Ctrl-C ends by damping, "
        "r or SIGUSR1 re-arms",
        file=out,
        flush=True,
    )
    end = _supervise(runner, out)
    result = run_summary(end, generation, runner.real_time)
    write_json(arguments.json, result)
    print(closing_text(result), file=out, flush=True)
    where = f"{arguments.host}:{arguments.port}"
    if end.reason in ("no_state", "wrong_generation"):
        print("surefoot: error:", no_robot_text(where, end, generation), file=sys.stderr)
        return NO_ROBOT
    return 0 if end.reason == "asked" else ENDED_DAMPED


def _make_runner(arguments: argparse.Namespace) -> tuple[StandRunner, str]:
    description = chosen_robot(arguments, default="go1")
    assert description is not None  # there is a default
    robot = build_robot(description)
    generation = arguments.sdk or default_generation(robot.name)
    options = RunOptions(
        rate=arguments.rate,
        duration=math.inf if arguments.duration is None else arguments.duration,
        power_level=arguments.power_level,
        remote=not arguments.no_remote,
    )
    stand = StandOptions(
        motor_damping=arguments.motor_damping,
        delay=arguments.predict_ms / 1000.0,
        form=read_form(arguments.form),
    )
    if arguments.power_limit is not None:
        stand.power_limit = arguments.power_limit
    runner = StandRunner(
        robot,
        arguments.host,
        arguments.port,
        generation,
        arguments.local_port,
        read_gains(arguments.gains, description),
        stand,
        options,
    )
    return runner, generation


def _supervise(runner: StandRunner, out: TextIO) -> RunSnapshot:
    """Run the loop in a thread of its own; watch it, the keyboard and signals from this one."""
    loop = threading.Thread(target=runner.run)
    former = {
        signal.SIGINT: signal.signal(signal.SIGINT, lambda *_: runner.stop()),
        signal.SIGTERM: signal.signal(signal.SIGTERM, lambda *_: runner.stop()),
        signal.SIGUSR1: signal.signal(signal.SIGUSR1, lambda *_: runner.rearm()),
    }
    loop.start()
    try:
        _watch(runner, loop.is_alive, out)
    finally:
        runner.stop()
        loop.join()
        for number, handler in former.items():
            signal.signal(number, handler)
    return runner.snapshot()


def _watch(runner: StandRunner, alive: Callable[[], bool], out: TextIO) -> None:
    said, phase, noticed = time.monotonic(), "", Notices(out)
    keys = sys.stdin.isatty() if sys.stdin else False
    while alive():
        time.sleep(_LOOK)
        if keys and select.select([sys.stdin], [], [], 0.0)[0] and "r" in sys.stdin.readline():
            runner.rearm()
        now = runner.snapshot()
        noticed.look(now)
        if now.phase != phase and now.time > 0.0:
            if not phase:
                print(runner.real_time, file=out, flush=True)
            phase = now.phase
            why = f": {why_damped(now)}" if phase == "damping" else ""
            print(f"{now.time:7.2f} s {phase}{why}", file=out, flush=True)
        if time.monotonic() - said > _LINE:
            said = time.monotonic()
            print(status_line(now), file=out, flush=True)
