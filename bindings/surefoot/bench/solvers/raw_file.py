"""Binary files that the solver executables read (QPs) and write (records of solves)."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt

from surefoot.bench.problems.qp_sequence import QpSequence

MAGIC = b"SFQPSEQ1"
# Fields of the record of one solve, all float64: times [ns]; status
# (benchmarks/solvers/adapter.hpp); counts (iterations is -1 if the solver does not report it);
# residuals of the optimality conditions ("gap" is the complementarity, see
# benchmarks/solvers/residuals.hpp); and the largest difference of a variable from the reference
# answer.
FIELDS = (
    "wall_ns",
    "cpu_ns",
    "status",
    "iterations",
    "allocations",
    "primal",
    "dual",
    "gap",
    "distance",
)
Records = dict[str, npt.NDArray[np.float64]]


def write_raw(sequence: QpSequence, path: Path) -> None:
    """Write the QPs of a sequence to a binary file.

    The file starts with MAGIC. Then follow four int64: the numbers of variables, equalities,
    inequalities and ticks. Then follow the arrays H, g, A, b, C, l, u as float64, each for all
    ticks.
    """
    size = (sequence.g.shape[1], sequence.b.shape[1], sequence.l.shape[1], len(sequence))
    with path.open("wb") as file:
        file.write(MAGIC)
        np.array(size, dtype=np.int64).tofile(file)
        for name in "HgAbClu":
            np.ascontiguousarray(getattr(sequence, name), dtype=np.float64).tofile(file)


def read_records(path: Path, ticks: int) -> Records:
    """Read the records of a run.

    Returns:
        For each name of FIELDS an array of shape (ticks,); NaN in ticks that the run did not reach.
    """
    rows = np.full((ticks, len(FIELDS)), np.nan)
    if path.is_file():
        found = np.fromfile(path).reshape(-1, len(FIELDS))
        rows[: len(found)] = found
    return {name: rows[:, k] for k, name in enumerate(FIELDS)}
