"""Run of the solver comparison: the solvers take turns on each sequence of QPs."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from surefoot._core import Error
from surefoot.bench.problems.qp_sequence import QpSequence
from surefoot.bench.solvers.raw_file import Records, write_raw
from surefoot.bench.solvers.solver_build import BASELINE, SOLVERS, SolverBuilder
from surefoot.bench.solvers.solver_process import SolverFiles, describe_solver, run_program
from surefoot.bench.solvers.solver_statistics import ACCEPT_FACTOR, solver_statistics
from surefoot.system.machine import describe_machine

MODES = ("warm", "cold")
# Chosen: TOLERANCE is sufficient for a controller. The reference answers are computed with a
# tolerance that is 1e6 times smaller.
TOLERANCE, REFERENCE_TOLERANCE = 1e-6, 1e-12  # tolerances on the residuals
_REFERENCE_SOLVER = "surefoot"
Runs = dict[str, dict[str, list[tuple[Records | None, str | None]]]]


def run_solvers(
    sequences: Iterable[QpSequence],
    solvers: Sequence[str] | None = None,
    repeats: int = 1,
    folder: Path | None = None,
    extra: Sequence[Path] = (),
) -> dict[str, Any]:
    """Solve every QP with every solver, with warm and cold starts; return figures as JSON values.

    Args:
        sequences: Sequences of QPs to solve.
        solvers: Names of SOLVERS or of extra adapters. None: all SOLVERS.
        repeats: Number of runs over each sequence; the solvers take turns.
        folder: Build folder of the executables. None: a folder in the user's cache.
        extra: Files of further adapters, which the repository does not have.

    Raises:
        Error: A name is unknown, or CMake or the sources are missing.
    """
    known = [*SOLVERS, *(path.stem for path in extra)]
    names = list(solvers) if solvers is not None else list(SOLVERS)
    for name in names:
        if name not in known:
            raise Error(f"solvers: got '{name}', expected some of {', '.join(known)}")
    builder = SolverBuilder(folder, extra)
    programs = {name: builder.build(name) for name in (BASELINE, *names)}
    reference_program = programs.get(_REFERENCE_SOLVER) or builder.build(_REFERENCE_SOLVER)
    descriptions = {name: _describe(program) for name, program in programs.items()}
    found = {
        s.name: _run_sequence(s, programs, reference_program, descriptions, repeats)
        for s in sequences
    }
    return {
        "tolerance": TOLERANCE,
        "accepted": ACCEPT_FACTOR * TOLERANCE,
        "repeats": repeats,
        "sequences": found,
        "machine": describe_machine(),
    }


def _describe(program: Path | str) -> dict[str, str]:
    return {"reason": program} if isinstance(program, str) else describe_solver(program)


def _run_sequence(
    sequence: QpSequence,
    programs: dict[str, Path | str],
    reference_program: Path | str,
    descriptions: dict[str, dict[str, str]],
    repeats: int,
) -> dict[str, Any]:
    ready = {name: path for name, path in programs.items() if isinstance(path, Path)}
    with tempfile.TemporaryDirectory(prefix="surefoot-solvers-") as name:
        folder = Path(name)
        write_raw(sequence, folder / "sequence")
        work = SolverFiles(folder / "sequence", None, len(sequence), folder / "records")
        reference: float | None = None
        if isinstance(reference_program, Path):
            # Rounding errors exceed REFERENCE_TOLERANCE, so the solver may report a failure. The
            # answers are still the most accurate ones available. run_program() writes the answers
            # to a file, and returns the records of their solves.
            answers, _ = run_program(
                reference_program, work, "warm", REFERENCE_TOLERANCE, folder / "answers"
            )
            reference = None if answers is None else _worst_residual(answers)
            work = SolverFiles(work.sequence, folder / "answers", work.ticks, work.records)
        runs: Runs = {name: {mode: [] for mode in MODES} for name in ready}
        for _ in range(repeats):
            for mode in MODES:
                for name, path in ready.items():
                    runs[name][mode].append(run_program(path, work, mode, TOLERANCE))
    entries = {
        name: {**descriptions[name], **_statistics_by_mode(runs.get(name))} for name in programs
    }
    return {
        "ticks": len(sequence),
        "variables": sequence.g.shape[1],
        "equalities": sequence.b.shape[1],
        "inequalities": sequence.l.shape[1],
        "reference_residual": reference,
        "baseline": entries.pop(BASELINE),
        "solvers": entries,
    }


def _worst_residual(records: Records) -> float | None:
    worst = max(float(records[name].max()) for name in ("primal", "dual", "gap"))
    return worst if np.isfinite(worst) else None


def _statistics_by_mode(
    runs: dict[str, list[tuple[Records | None, str | None]]] | None,
) -> dict[str, Any]:
    if runs is None:
        return {"warm": None, "cold": None}
    entry: dict[str, Any] = {}
    for mode, done in runs.items():
        found = [records for records, _ in done if records is not None]
        reason = next((why for _, why in done if why is not None), None)
        entry[mode] = {"reason": reason}
        if found:
            joined = {name: np.concatenate([r[name] for r in found]) for name in found[0]}
            entry[mode] |= solver_statistics(joined, TOLERANCE)
    return entry
