"""One solver's program over one sequence, in a process of its own: what crashes crashes alone."""

from __future__ import annotations

import signal
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from surefoot.bench.solvers.raw_file import Records, read_records

NO_WARM_START_EXIT = 3  # the program's word for it
TIME_LIMIT = 300.0  # [s] of a sequence


@dataclass(frozen=True)
class SolverFiles:
    """Files of a sequence.

    Attributes:
        sequence: Its programs.
        reference: What to compare with, or None.
        ticks: How many.
        records: Where a run's records go.
    """

    sequence: Path
    reference: Path | None
    ticks: int
    records: Path


def describe_solver(program: Path) -> dict[str, str]:
    """Return what a program says of itself."""
    done = subprocess.run([program, "describe"], capture_output=True, text=True, check=False)
    names = ("name", "interface", "version", "settings", "warm_start")
    lines = [*done.stdout.splitlines()[-len(names) :], *[""] * len(names)]
    return dict(zip(names[1:], lines[1 : len(names)], strict=True))


def run_program(
    program: Path, work: SolverFiles, mode: str, tolerance: float, write: Path | None = None
) -> tuple[Records | None, str | None]:
    """Return the records, None if it has no such mode, and why it did not reach the end."""
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
            stdout=subprocess.DEVNULL,  # some print in every solve
            stderr=subprocess.PIPE,
            timeout=TIME_LIMIT,
            check=False,
        )
        code, message = done.returncode, done.stderr.decode(errors="replace").strip()
    except subprocess.TimeoutExpired:
        code, message = 0, f"stopped after {TIME_LIMIT:g} s"
    if code == NO_WARM_START_EXIT:
        return None, "keeps nothing from tick to tick"
    records = read_records(work.records, work.ticks)
    reached = int(np.isfinite(records["status"]).sum())
    if code < 0:
        message = signal.Signals(-code).name
    if code == 0 and reached == work.ticks:
        return records, None
    return records, f"{message or f'left with {code}'} after {reached} of {work.ticks} ticks"
