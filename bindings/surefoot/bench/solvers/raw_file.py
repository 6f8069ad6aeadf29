"""Binary files that the solver executables read and write: float64 values."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt

from surefoot.bench.problems.qp_sequence import QpSequence

MAGIC = b"SFQPSEQ1"
# Fields of the record of one solve: times [ns], status, counts (-1: not reported), residuals, and
# distance to the reference answer.
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
    """Write MAGIC, int64 n, equalities, inequalities, ticks, then H, g, A, b, C, l, u."""
    size = (sequence.g.shape[1], sequence.b.shape[1], sequence.l.shape[1], len(sequence))
    with path.open("wb") as file:
        file.write(MAGIC)
        np.array(size, dtype=np.int64).tofile(file)
        for name in "HgAbClu":
            np.ascontiguousarray(getattr(sequence, name), dtype=np.float64).tofile(file)


def read_records(path: Path, ticks: int) -> Records:
    """Return the fields of a run by name, (ticks,) each; NaN in ticks that were not reached."""
    rows = np.full((ticks, len(FIELDS)), np.nan)
    if path.is_file():
        found = np.fromfile(path).reshape(-1, len(FIELDS))
        rows[: len(found)] = found
    return {name: rows[:, k] for k, name in enumerate(FIELDS)}
