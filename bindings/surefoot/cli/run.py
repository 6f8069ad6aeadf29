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
from typing import Any, TextIO

from surefoot._core import RunOptions, RunSnapshot, StandOptions, StandRunner
from surefoot.cli.robot_choice import chosen_robot
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
    result = _summary(runner, end, generation)
    write_json(arguments.json, result)
    print(_closing_text(result), file=out, flush=True)
    if end.reason in ("no_state", "wrong_generation"):
        print("surefoot: error:", _no_robot_text(arguments, end, generation), file=sys.stderr)
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
    said, phase = time.monotonic(), ""
    keys = sys.stdin.isatty() if sys.stdin else False
    while alive():
        time.sleep(_LOOK)
        if keys and select.select([sys.stdin], [], [], 0.0)[0] and "r" in sys.stdin.readline():
            runner.rearm()
        now = runner.snapshot()
        if now.phase != phase:
            phase = now.phase
            why = f": {_why(now)}" if phase == "damping" else ""
            print(f"{now.time:7.2f} s {phase}{why}", file=out, flush=True)
        if time.monotonic() - said > _LINE:
            said = time.monotonic()
            print(_status_line(now), file=out, flush=True)


def _why(now: RunSnapshot) -> str:
    if now.reason == "stale":
        return f"stale: no LowState for {1000 * now.silence:.0f} ms"
    if now.reason == "controller":
        return f"the controller found {now.fault.name}"
    if now.reason == "power_protect":
        return f"power protection: {now.power:.0f} W"
    return now.reason


def _status_line(now: RunSnapshot) -> str:
    link = now.link
    return (
        f"{now.time:7.2f} s {now.phase:8} height {now.height:.3f} m, tilt "
        f"{math.degrees(now.tilt):.1f} deg, {now.power:.0f} W; states {link.valid}, lost "
        f"{link.lost}, bad {link.corrupt + link.wrong_length + link.wrong_generation}, age "
        f"{1000 * now.age:.0f} ms; tick {now.tick_p50:.0f} us, {now.tick_p999:.0f} p99.9"
    )


def _summary(runner: StandRunner, end: RunSnapshot, generation: str) -> dict[str, Any]:
    names = [name for name in dir(end.link) if not name.startswith("_")]
    times = [name for name in dir(end) if name.startswith(("tick_", "wake_"))]
    return {
        "generation": generation,
        "phase": end.phase,
        "reason": end.reason,
        "fault": end.fault.name,
        "reject": end.reject,
        "time_s": end.time,
        "ticks": end.ticks,
        "usable_ticks": end.usable,
        "bridged_ticks": end.bridged,
        "saturated_ticks": end.saturated,
        "missed_periods": end.missed,
        "dampings": end.dampings,
        "rearms": end.rearms,
        "greatest_power_w": end.greatest_power,
        "height_m": end.height,
        "tilt_deg": math.degrees(end.tilt),
        "age_s": end.age if math.isfinite(end.age) else None,
        "link": {name: getattr(end.link, name) for name in names},
        "us": {name: getattr(end, name) for name in times},
        "real_time": runner.real_time,
    }


def _closing_text(result: dict[str, Any]) -> str:
    us, link = result["us"], result["link"]
    return (
        f"ended after {result['time_s']:.2f} s: {result['reason']}; {result['ticks']} ticks, "
        f"{result['bridged_ticks']} without a new state, "
        f"{result['ticks'] - result['usable_ticks'] - result['bridged_ticks']} failed, "
        f"{result['missed_periods']} periods missed\n"
        f"  link  {link['valid']} states, {link['lost']} lost, {link['late']} late, "
        f"{link['duplicate']} duplicate, {link['reordered']} reordered, {link['corrupt']} corrupt, "
        f"{link['strangers']} from strangers, {link['floods']} floods\n"
        f"  tick  {us['tick_p50']:.0f} us median, {us['tick_p90']:.0f} p90, {us['tick_p99']:.0f} "
        f"p99, {us['tick_p999']:.0f} p99.9, {us['tick_max']:.0f} max; woken {us['wake_p50']:.0f} "
        f"us late, {us['wake_p99']:.0f} p99, {us['wake_max']:.0f} max\n"
        f"  {result['real_time']}"
    )


def _no_robot_text(arguments: argparse.Namespace, end: RunSnapshot, generation: str) -> str:
    where = f"{arguments.host}:{arguments.port}"
    if end.reason == "wrong_generation":
        return f"the robot at {where} does not speak {generation}: {end.reject}; see --sdk"
    if end.link.received:
        return f"no valid LowState from {where}: {end.reject}"
    return f"nobody answers at {where}; a virtual robot is started with surefoot robot"
