# SPDX-License-Identifier: BSD-3-Clause
"""Mutated sensor logs: each is refused by line, column or field, or estimated with finite figures.

    python benchmarks/mutate_logs.py --count 2000 --jobs 2 --json FILE

Each seed takes the recording of a robot, changes columns and file, and estimates it with the
command `surefoot estimate`. Most seeds change the columns in a way that may matter; the others do
not, and the estimate must then be that of the recording. A case fails if the command raises, needs
over 10 s, prints figures that are not finite, or refuses without a place. To keep the file of a
case: --first SEED --count 1 --keep FOLDER. tests/python has a short form of this benchmark.
"""

from __future__ import annotations

import argparse
import contextlib
import functools
import io
import json
import math
import os
import re
import signal
import sys
import tempfile
import time
import traceback
import warnings
from collections.abc import Iterator
from pathlib import Path
from types import FrameType
from typing import Any

import numpy as np
from log_file_mutations import write_mutant
from log_mutations import HARMFUL, HARMLESS, Columns, MutantLog
from seed_runs import Job, MutantOutcome, add_seed_options, run_mutants
from surefoot.cli import main as surefoot
from surefoot.estimate import SensorLog, write_log
from surefoot.stand import SensorRecorder, StandSettings, parse_reference, run_stand

DURATION = 1.2  # [s] of a recording
MAX_TIME = 10.0  # [s] of a case; the processor's time, for the machine may be shared
HARMLESS_SHARE = 0.3
FIGURES = ("position", "velocity", "rpy_deg", "position_std", "velocity_std")
# Largest difference of a figure of a harmless mutant. Derived: a clock of nanoseconds since 1970 is
# rounded to 0.25 us in float64, 1e-4 of a step.
MAX_DIFFERENCE = 1e-4
# A refusal names its place: a line, a column, an array, or what the whole file lacks.
PLACE = re.compile(
    r"line \d+|row \d+|message \d+|columns? '|columns? without|unequal length|missing column"
    r"|empty file|no valid NPZ|a header and no rows|no arrays|no usable row|NUL|name ends in"
)


def main() -> int:
    """Run the requested cases, print and write JSON; return 3 if one fails."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add_seed_options(parser, count=2000)
    parser.add_argument("--keep", metavar="FOLDER", help="write the files of the cases here")
    options = parser.parse_args()
    if options.keep:
        os.environ["SUREFOOT_KEEP_LOGS"] = str(Path(options.keep).resolve())
    return run_mutants(run_case, "cases", options)


@functools.cache
def recording(robot: str, moving: bool) -> Columns:
    """Return the sensor columns of a robot that stands still, or turns and leans on its feet."""
    requests = ("yaw=8,roll=6,pitch=-4@0.2", "yaw=-6,roll=0@0.7") if moving else ()
    recorder = SensorRecorder()
    references = tuple(map(parse_reference, requests))
    run_stand(StandSettings(robot, DURATION, references=references), sensors=recorder)
    columns = recorder.log().columns
    return {name: v for name, v in columns.items() if not name.startswith("truth_")}


@functools.cache
def reference(robot: str, moving: bool) -> dict[str, Any]:
    """Return the summary of a recording without mutations."""
    columns = recording(robot, moving)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "log.csv"
        write_log(path, SensorLog("recording", columns, columns["tick"][:, 0]))
        status, _, summary = estimate(path, robot)
    assert status == 0 and summary is not None
    return summary


def run_case(job: Job) -> MutantOutcome:
    """Run one case."""
    robot, seed = str(job[0]), int(job[1])
    rng = np.random.default_rng(seed)
    moving = bool(rng.random() < 0.5)
    log = MutantLog({name: values.copy() for name, values in recording(robot, moving).items()})
    log.harmless = bool(rng.random() < HARMLESS_SHARE)
    kinds = HARMLESS if log.harmless else HARMFUL
    for k in rng.choice(len(kinds), int(rng.integers(1, 4)), replace=False).tolist():
        if log.columns:
            log.changes.append(kinds[k](log, rng))
    with tempfile.TemporaryDirectory() as folder:
        folder = os.environ.get("SUREFOOT_KEEP_LOGS", folder)
        path = write_mutant(Path(folder), log, str(rng.choice(["csv", "npz"])), rng)
        expected = reference(robot, moving) if log.harmless else None
        start = time.process_time()
        try:
            with _time_limit(MAX_TIME), warnings.catch_warnings():
                warnings.simplefilter("error")  # a warning of numpy is a message without a remedy
                status, message, summary = estimate(path, robot)
        except BaseException:
            return MutantOutcome(False, traceback.format_exc()[-700:], "raises", "", log.changes)
        why = _judge(status, message, summary, expected)
        if time.process_time() - start > MAX_TIME:
            why = why or f"needs {time.process_time() - start:.0f} s"
    end = "refused" if status else "same" if log.harmless else "estimated"
    return MutantOutcome(not why, why and f"{why}: {log.changes}", end, message, log.changes)


def estimate(path: Path, robot: str) -> tuple[int, str, dict[str, Any] | None]:
    """Run surefoot estimate; return its status, its last line on stderr, and the summary."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        status = surefoot(["estimate", str(path), "--robot", robot, "--json", "-"])
    lines = err.getvalue().splitlines()
    return status, lines[-1] if lines else "", json.loads(out.getvalue() or "null")


def _judge(
    status: int, message: str, summary: dict[str, Any] | None, expected: dict[str, Any] | None
) -> str:
    """Return why a result is wrong, or "" if it is right."""
    if status:
        if expected is not None:
            return f"a harmless log is refused: {message}"
        known = message.startswith("surefoot: error: ") and PLACE.search(message)
        return "" if known else f"status {status} without a place: {message}"
    if summary is None:
        return "no summary"
    for name in FIGURES:
        if not all(value is not None and math.isfinite(value) for value in summary[name]):
            return f"{name} is {summary[name]}"
        if expected is not None:
            difference = np.abs(np.subtract(summary[name], expected[name])).max()
            if difference > MAX_DIFFERENCE:
                return f"{name} of a harmless log differs by {difference:.2g}"
    return ""


@contextlib.contextmanager
def _time_limit(seconds: float) -> Iterator[None]:
    """Raise TimeoutError after a time of the processor [s]."""

    def stop(number: int, frame: FrameType | None) -> None:
        raise TimeoutError(f"hangs for {seconds:g} s")

    signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)


if __name__ == "__main__":
    sys.exit(main())
