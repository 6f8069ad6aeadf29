# SPDX-License-Identifier: BSD-3-Clause
"""Mutated robots: each is refused by name, or plant and controller agree and it stands.

    python benchmarks/mutate_robots.py --count 2000 --jobs 2 --json FILE

Each seed changes one to three elements of the URDF, SRDF and TOML of a known robot: dropped,
doubled, negated, scaled, renamed, reordered. The mutant passes if loading raises surefoot.Error
with the name of an element, or if MuJoCo and Pinocchio agree to 1e-6 of the largest entry and a
stand of 2 s ends without an exception; a fall must have a status. tests/closed_loop has a short
form of this benchmark.
"""

from __future__ import annotations

import argparse
import multiprocessing
import random
import re
import resource
import sys
import tempfile
import traceback
from dataclasses import asdict
from multiprocessing.connection import Connection
from pathlib import Path

import numpy as np
from robot_mutations import MutantFiles, write_mutant
from seed_runs import Job, MutantOutcome, add_seed_options, run_mutants
from surefoot import Error, Status
from surefoot.robot.loading import build_robot, describe_robot
from surefoot.sim.model.agreement import compare_models
from surefoot.stand import StandSettings, run_stand

STAND_TIME = 2.0  # [s]
MAX_DIFFERENCE = 1e-6  # share of the largest entry
MAX_CPU_TIME = 10.0  # [s] of a mutant; a machine under load takes longer by the clock
MAX_WALL_TIME = 120.0  # [s] after which a mutant that uses no processor is a hang
STATUS_TIME = 0.5  # [s] before the end of a fall in which a status must appear


def main() -> int:
    """Run the requested mutants, print and write JSON; return 3 if one fails."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add_seed_options(parser, count=2000)
    options = parser.parse_args()
    return run_mutants(run_mutant, "mutants", options)


def run_mutant(job: Job) -> MutantOutcome:
    """Run one mutant in a process of its own, so that a crash or a hang is found."""
    context = multiprocessing.get_context("fork")
    receiver, sender = context.Pipe(duplex=False)
    process = context.Process(target=_run_in_child, args=(job, sender))
    process.start()
    sender.close()
    try:
        # On a machine under load a process may wait long for a processor; its CPU time is limited.
        while not receiver.poll(MAX_WALL_TIME) and _is_running(process.pid):
            pass
        if receiver.poll():
            return MutantOutcome(**receiver.recv())
        why = f"hangs for {MAX_WALL_TIME:.0f} s"
    except EOFError:
        process.join()
        why = f"the process ended with {process.exitcode}"
    finally:
        process.kill()
        process.join()
    return MutantOutcome(False, why, "lost", "", _changes(job))


def _is_running(pid: int | None) -> bool:
    state = Path(f"/proc/{pid}/stat").read_text(encoding="ascii").rpartition(")")[2].split()[0]
    return state == "R"


def _changes(job: Job) -> list[str]:
    with tempfile.TemporaryDirectory() as folder:
        return _write(job, Path(folder)).changes


def _write(job: Job, folder: Path) -> MutantFiles:
    name, seed = job
    return write_mutant(describe_robot(str(name)), random.Random(seed), folder)


def _run_in_child(job: Job, sender: Connection) -> None:
    # SIGXCPU ends the process.
    used = resource.getrusage(resource.RUSAGE_SELF)
    limit = int(used.ru_utime + used.ru_stime + MAX_CPU_TIME) + 1
    resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))
    with tempfile.TemporaryDirectory() as folder:
        files = _write(job, Path(folder))
        try:
            mutant = judge(files)
        except Exception:
            last = traceback.format_exc().strip().splitlines()[-6:]
            mutant = MutantOutcome(
                False, " | ".join(line.strip() for line in last), "traceback", "", []
            )
        mutant.changes = files.changes
        if not mutant.ok:
            mutant.why += f"; changes: {'; '.join(files.changes)}"
        sender.send(asdict(mutant))


def judge(files: MutantFiles) -> MutantOutcome:
    """Load a mutant, compare its two models and let it stand."""
    try:
        description = describe_robot(urdf=files.urdf, config=files.config)
        robot = build_robot(description)
        agreement = compare_models(robot, description)
        if not agreement.worst <= MAX_DIFFERENCE:
            return MutantOutcome(False, f"the models differ: {agreement}", "differs", "", [])
        log = run_stand(StandSettings(robot=description, duration=STAND_TIME))
    except Error as problem:
        message = str(problem)
        return MutantOutcome(
            names_element(message, files), f"no name in: {message}", "refused", message, []
        )
    if not log.fell:
        return MutantOutcome(True, "", "stood", "", [])
    late = log.status[log.time > log.time[-1] - STATUS_TIME]
    ok = bool(np.any(late != Status.OK.value))
    return MutantOutcome(ok, "fell, and the status stayed OK", "fell", "", [])


def names_element(message: str, files: MutantFiles) -> bool:
    """Return True if an error message names an element of the files, or a line."""
    text = message.replace(str(files.urdf), "").replace(str(files.config), "")
    text = re.sub(r"^robot '[^']*'", "", text.replace(str(files.urdf.with_suffix(".srdf")), ""))
    return bool(re.search(r"line \d", text)) or any(name in text for name in files.names)


if __name__ == "__main__":
    sys.exit(main())
