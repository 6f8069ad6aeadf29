"""Run of one solver over one sequence of QPs, in a separate process: a solver may crash."""

from __future__ import annotations

import signal
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from surefoot.bench.solvers.raw_file import Records, read_records

NO_WARM_START_EXIT = 3  # exit status of a solver that cannot warm start
# [s] Longest time of a solver for a sequence. Chosen: a sequence usually takes seconds; this limit
# ends a solver that hangs.
TIME_LIMIT = 300.0


@dataclass(frozen=True)
class SolverFiles:
    """Files of a sequence.

    Attributes:
        sequence: File of the QPs.
        reference: File of the reference answers. None: there are none.
        ticks: Number of QPs.
        records: File in which a run writes its records.
    """

    sequence: Path
    reference: Path | None
    ticks: int
    records: Path


def describe_solver(program: Path) -> dict[str, str]:
    """Return the texts that an executable reports about its solver.

    "interface" is the language of the API through which the solver is called. "version" and
    "settings" are those of the solver. "warm_start" states what the solver keeps from one tick to
    the next.
    """
    done = subprocess.run([program, "describe"], capture_output=True, text=True, check=False)
    names = ("name", "interface", "version", "settings", "warm_start")
    lines = [*done.stdout.splitlines()[-len(names) :], *[""] * len(names)]
    return dict(zip(names[1:], lines[1 : len(names)], strict=True))


def run_program(
    program: Path, work: SolverFiles, mode: str, tolerance: float, write: Path | None = None
) -> tuple[Records | None, str | None]:
    """Run a solver over a sequence.

    Args:
        program: Executable of the solver.
        work: Files of the sequence.
        mode: "warm": each solve may start from the result of the last tick; or "cold".
        tolerance: Tolerance that the solver has to meet.
        write: File to which the executable writes its answers. None: they are not written.

    Returns:
        The records, and the reason why the run stopped early (None after a full run). In mode
        "warm" the records are None if the solver has no warm start.
    """
    work.records.unlink(missing_ok=True)
    arguments: list[str | Path] = [
        program,
        work.sequence,
        mode,
        work.records,
        work.reference or "-",
    ]
    arguments += [repr(tolerance), *([write] if write is not None else [])]
    try:
        done = subprocess.run(
            arguments,
            stdout=subprocess.DEVNULL,  # some solvers print in every solve
            stderr=subprocess.PIPE,
            timeout=TIME_LIMIT,
            check=False,
        )
        code, message = done.returncode, done.stderr.decode(errors="replace").strip()
    except subprocess.TimeoutExpired:
        code, message = 0, f"stopped after {TIME_LIMIT:g} s"
    if code == NO_WARM_START_EXIT:
        return None, "has no warm start"
    records = read_records(work.records, work.ticks)
    reached = int(np.isfinite(records["status"]).sum())
    if code < 0:
        message = signal.Signals(-code).name
    if code == 0 and reached == work.ticks:
        return records, None
    return (
        records,
        f"{message or f'ended with status {code}'} after {reached} of {work.ticks} ticks",
    )
