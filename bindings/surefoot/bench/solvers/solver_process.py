"""Run of one solver over one sequence, in a separate process, because solvers may crash."""

from __future__ import annotations

import signal
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from surefoot.bench.solvers.raw_file import Records, read_records

NO_WARM_START_EXIT = 3  # exit status of a solver that cannot warm start
# Chosen: a sequence takes seconds; a solver that hangs must end.
TIME_LIMIT = 300.0  # [s] longest time of a solver for a sequence


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
    """Return the interface, version, settings and warm start that an executable reports."""
    done = subprocess.run([program, "describe"], capture_output=True, text=True, check=False)
    names = ("name", "interface", "version", "settings", "warm_start")
    lines = [*done.stdout.splitlines()[-len(names) :], *[""] * len(names)]
    return dict(zip(names[1:], lines[1 : len(names)], strict=True))


def run_program(
    program: Path, work: SolverFiles, mode: str, tolerance: float, write: Path | None = None
) -> tuple[Records | None, str | None]:
    """Run a solver; return its records, and the reason why the solver did not reach the end.

    The records are None if the solver has no warm start. The reason is None after a full run.
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
