# SPDX-License-Identifier: BSD-3-Clause
"""Verdicts of `surefoot estimate` on logs of walking robots: healthy ones and ones with a fault.

    python benchmarks/sensor_verdicts.py --robot go1 --healthy 50 --faulty 5 --folder out/verdicts

Each seed is a walk that turns by 90 degrees or more. A healthy log must have no verdict, neither
with all columns nor without torques, velocities and quaternion. A faulty log is judged 5 s and
10 s after the first step, or after the onset of a fault in the middle of the log. The verdict is
right if it names the fault and nothing else. Logs are kept in --folder; they depend on the
controller that recorded them.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import surefoot
from seed_runs import ROBOTS
from sensor_faults import draw_faults, with_fault
from surefoot import Error, Robot
from surefoot.cli.output_files import write_json
from surefoot.estimate import SensorLog
from surefoot.estimate.checks import check_log
from verdict_walks import load_walk

TIMES = (5.0, 10.0)  # [s] after the first step or the onset
FIRST_STEP = 1.5  # [s] latest time of the first command
VARIANTS: dict[str, tuple[str, ...]] = {
    "all columns": (),
    "no torques, dq, quaternion": ("tauEst", "dq", "quaternion"),
}


def verdicts(robot: Robot, log: SensorLog) -> list[str]:
    """Return the warnings about a log, or the error."""
    try:
        return check_log(robot, log)
    except Error as error:
        return [str(error)]


def without(log: SensorLog, names: tuple[str, ...]) -> SensorLog:
    """Return a log without some columns."""
    return replace(log, columns={n: v for n, v in log.columns.items() if n not in names})


def until(log: SensorLog, time: float) -> SensorLog:
    """Return the rows of a log up to a time [s]."""
    rows = log.time <= time
    columns = {name: values[rows] for name, values in log.columns.items()}
    return replace(log, columns=columns, time=log.time[rows])


def walks(options: argparse.Namespace, name: str, count: int) -> Iterator[tuple[int, SensorLog]]:
    """Yield the first `count` logs that turn far enough, with their seeds."""
    seed = found = 0
    while found < count:
        log = load_walk(options.folder, name, seed)
        if log is not None:
            found += 1
            yield seed, log
        seed += 1


def judge_healthy(options: argparse.Namespace, name: str) -> dict[str, list[str]]:
    """Return the false verdicts of each variant."""
    robot = surefoot.load_robot(name)
    false: dict[str, list[str]] = {variant: [] for variant in VARIANTS}
    for seed, log in walks(options, name, options.healthy):
        for variant, missing in VARIANTS.items():
            found = [f"{name} {seed}: {text}" for text in verdicts(robot, without(log, missing))]
            false[variant] += found
            print("".join(f"{variant}: {text}\n" for text in found), end="", file=sys.stderr)
    return false


def judge_faulty(options: argparse.Namespace, name: str) -> dict[str, Counter[str]]:
    """Return for each fault the number of logs by outcome: right (by time), wrong, missed."""
    robot = surefoot.load_robot(name)
    counts: dict[str, Counter[str]] = {}
    missing = VARIANTS[options.variant]
    for seed, log in walks(options, name, options.faulty):
        middle = len(log.time) // 3
        for fault in draw_faults(np.random.default_rng([seed, 17])):
            if fault.foot_forces and not np.any(log.columns["footForce"]):
                continue
            count = counts.setdefault(fault.name, Counter())
            count["logs"] += 1
            broken = without(with_fault(log, fault, middle), missing)
            begin = log.time[middle] if fault.halfway else FIRST_STEP
            for time in TIMES:
                found = verdicts(robot, until(broken, begin + time))
                right = [bool(re.search(fault.verdict, text)) for text in found]
                outcome = "missed" if not found else "right" if all(right) else "wrong"
                count[f"{outcome} {time:g}"] += 1
                if outcome != "right" and time == TIMES[-1]:
                    print(f"{name} {seed} {fault.name}: {outcome} {found}", file=sys.stderr)
    return counts


def main() -> None:
    """Judge all logs and print the tables."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--robot", nargs="+", choices=ROBOTS, default=list(ROBOTS))
    parser.add_argument("--healthy", type=int, default=50, help="healthy logs per robot")
    parser.add_argument("--faulty", type=int, default=5, help="logs per robot and fault")
    parser.add_argument("--variant", choices=tuple(VARIANTS), default="all columns")
    parser.add_argument("--folder", type=Path, default=Path("out/verdicts"))
    parser.add_argument("--json", help="also write the counts as JSON")
    options = parser.parse_args()
    results = {}
    for name in options.robot:
        healthy, faulty = judge_healthy(options, name), judge_faulty(options, name)
        results[name] = {"healthy": healthy, "faulty": faulty}
        for variant, texts in healthy.items():
            print(f"{name} healthy, {variant}: {len(texts)} false verdicts, {options.healthy} logs")
            print("".join(f"    {text}\n" for text in texts), end="")
        for fault, count in faulty.items():
            named = ", ".join(f"{count[f'right {t:g}']} in {t:g} s" for t in TIMES)
            last = f"{TIMES[-1]:g}"
            wrong, missed = count[f"wrong {last}"], count[f"missed {last}"]
            print(f"{name} {fault}: {named} of {count['logs']}; {wrong} wrong, {missed} missed")
        sys.stdout.flush()
    write_json(options.json, results, 1)


if __name__ == "__main__":
    main()
