"""Export of sequences to qpbenchmark, as a folder with a test set."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from surefoot.bench.problems.qp_sequence import QpSequence

TEST_SET = '''\
"""Whole-body control QPs of quadrupeds. Run: qpbenchmark surefoot_wbc.py run"""

from pathlib import Path
from typing import Any

import qpbenchmark


class SurefootWbc(qpbenchmark.TestSet):
    """All QPs of the folder data, as read by qpsolvers.Problem.load()."""

    description = "Whole-body torque control of Unitree quadrupeds, recorded tick after tick."
    sparse_only = False
    title = "Surefoot whole-body control"

    def __iter__(self):
        for path in sorted((Path(__file__).parent / "data").glob("*.npz")):
            yield qpbenchmark.Problem.load(str(path))
'''


def export_qpbenchmark(sequences: Iterable[QpSequence], folder: Path, every: int = 50) -> int:
    """Write FOLDER/surefoot_wbc.py, and one in `every` QPs as ``FOLDER/data/*.npz``.

    qpbenchmark solves each QP with a cold start and takes minutes per thousand QPs. So the function
    writes only a part of the QPs. A two-sided constraint becomes two rows of G x <= h.

    Returns:
        Number of QPs written.
    """
    data = folder / "data"
    data.mkdir(parents=True, exist_ok=True)
    (folder / "surefoot_wbc.py").write_text(TEST_SET, encoding="utf-8")
    count = 0
    for sequence in sequences:
        for k in range(0, len(sequence), every):
            np.savez(
                data / f"{sequence.name}-{sequence.tick[k]:06d}.npz", **_qpsolvers(sequence, k)
            )
            count += 1
    return count


def _qpsolvers(s: QpSequence, k: int) -> dict[str, Any]:
    upper, lower = np.isfinite(s.u[k]), np.isfinite(s.l[k])
    none = np.array(None)  # value of a missing matrix in the files of qpsolvers
    equalities = {"A": s.A[k], "b": s.b[k]} if s.b.shape[1] else {"A": none, "b": none}
    return {
        "P": s.H[k],
        "q": s.g[k],
        "G": np.vstack([s.C[k][upper], -s.C[k][lower]]),
        "h": np.concatenate([s.u[k][upper], -s.l[k][lower]]),
        **equalities,
        "lb": none,
        "ub": none,
    }
