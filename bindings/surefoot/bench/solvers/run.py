"""Solvers in alternation over sequences."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable
from collections.abc import Sequence as Listed
from pathlib import Path
from typing import Any

import numpy as np

from surefoot._core import Error
from surefoot.bench.machine import describe_machine
from surefoot.bench.problems.sequence import Sequence
from surefoot.bench.solvers.build import BASELINE, SOLVERS, Builder
from surefoot.bench.solvers.figures import ACCEPT, figures
from surefoot.bench.solvers.process import Work, describe, run_program
from surefoot.bench.solvers.raw_file import Records, write_raw

MODES = ("warm", "cold")
TOLERANCE, TIGHT = 1e-6, 1e-12
_OWN = "surefoot"
Runs = dict[str, dict[str, list[tuple[Records | None, str | None]]]]


def run_solvers(
    sequences: Iterable[Sequence],
    solvers: Listed[str] | None = None,
    repeats: int = 1,
    folder: Path | None = None,
    extra: Listed[Path] = (),
) -> dict[str, Any]:
    """Solve every program with every solver, warm and cold, and return the figures as JSON types.

    Args:
        sequences: What to solve.
        solvers: Names of SOLVERS or of extra adapters; None is all of SOLVERS.
        repeats: Times over each sequence; solvers take turns.
        folder: To build the programs in; None is the user's cache.
        extra: Adapter files besides.

    Raises:
        Error: An unknown name, or nothing to build with.
    """
    known = [*SOLVERS, *(path.stem for path in extra)]
    names = list(solvers) if solvers is not None else list(SOLVERS)
    for name in names:
        if name not in known:
            raise Error(f"solvers: got '{name}', expected some of {', '.join(known)}")
    builder = Builder(folder, extra)
    programs = {name: builder.program(name) for name in (BASELINE, *names)}
    own = programs.get(_OWN) or builder.program(_OWN)
    about = {name: _about(program) for name, program in programs.items()}
    found = {s.name: _run_sequence(s, programs, own, about, repeats) for s in sequences}
    return {
        "tolerance": TOLERANCE,
        "accepted": ACCEPT * TOLERANCE,
        "repeats": repeats,
        "sequences": found,
        "machine": describe_machine(),
    }


def _about(program: Path | str) -> dict[str, str]:
    return {"reason": program} if isinstance(program, str) else describe(program)


def _run_sequence(
    sequence: Sequence,
    programs: dict[str, Path | str],
    own: Path | str,
    about: dict[str, dict[str, str]],
    repeats: int,
) -> dict[str, Any]:
    ready = {name: path for name, path in programs.items() if isinstance(path, Path)}
    with tempfile.TemporaryDirectory(prefix="surefoot-solvers-") as name:
        folder = Path(name)
        write_raw(sequence, folder / "sequence")
        work = Work(folder / "sequence", None, len(sequence), folder / "records")
        reference: float | None = None
        if isinstance(own, Path):
            # Asked for more than rounding leaves it says that it failed; what it has is the best.
            answers, _ = run_program(own, work, "warm", TIGHT, folder / "answers")
            reference = None if answers is None else _worst(answers)
            work = Work(work.sequence, folder / "answers", work.ticks, work.records)
        runs: Runs = {name: {mode: [] for mode in MODES} for name in ready}
        for _ in range(repeats):
            for mode in MODES:
                for name, path in ready.items():
                    runs[name][mode].append(run_program(path, work, mode, TOLERANCE))
    entries = {name: {**about[name], **_entry(runs.get(name))} for name in programs}
    return {
        "ticks": len(sequence),
        "variables": sequence.g.shape[1],
        "equalities": sequence.b.shape[1],
        "inequalities": sequence.l.shape[1],
        "reference_residual": reference,
        "baseline": entries.pop(BASELINE),
        "solvers": entries,
    }


def _worst(records: Records) -> float | None:
    worst = max(float(records[name].max()) for name in ("primal", "dual", "gap"))
    return worst if np.isfinite(worst) else None


def _entry(runs: dict[str, list[tuple[Records | None, str | None]]] | None) -> dict[str, Any]:
    if runs is None:
        return {"warm": None, "cold": None}
    entry: dict[str, Any] = {}
    for mode, done in runs.items():
        found = [records for records, _ in done if records is not None]
        reason = next((why for _, why in done if why is not None), None)
        entry[mode] = {"reason": reason}
        if found:
            joined = {name: np.concatenate([r[name] for r in found]) for name in found[0]}
            entry[mode] |= figures(joined, TOLERANCE)
    return entry
