"""Sequence of QPs of one size, and its file format."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from surefoot._core import Error, QpProblem
from surefoot.files.corrupt_npz import CORRUPT_NPZ

Array = npt.NDArray[np.float64]
FORMAT = "surefoot-qp-sequence-1"
# A bound of this magnitude or more counts as infinite. Numerical: ProxQP's value for infinity;
# every force and acceleration is far smaller.
NO_BOUND = 1e20
_ARRAYS = ("H", "g", "A", "b", "C", "l", "u")


@dataclass(frozen=True)
class QpSequence:
    """QPs of consecutive ticks: minimise 1/2 x'Hx + g'x  subject to  Ax = b,  l <= Cx <= u.

    Attributes:
        meta: Origin of the QPs: format, robot, scenario, form, elastic, rate [Hz], seed, versions.
        tick: (T,) int64, index of the control period of each QP.
        H: (T, n, n) symmetric matrices of the cost.
        g: (T, n) vectors of the cost.
        A: (T, equalities, n) matrices of the equalities.
        b: (T, equalities) right-hand sides of the equalities.
        C: (T, inequalities, n) matrices of the inequalities.
        l: (T, inequalities) lower bounds; -inf if there is none.
        u: (T, inequalities) upper bounds; inf if there is none.
    """

    meta: dict[str, Any]
    tick: npt.NDArray[np.int64]
    H: Array
    g: Array
    A: Array
    b: Array
    C: Array
    l: Array  # noqa: E741  (the usual name of the lower bound)
    u: Array

    def __len__(self) -> int:
        return len(self.tick)

    @property
    def name(self) -> str:
        """Name robot-scenario-form, with -elastic appended if slacks are among the variables."""
        meta = self.meta
        words = [meta["robot"], meta["scenario"], meta["form"]]
        return "-".join([*words, "elastic"] if meta["elastic"] else words)

    def save(self, folder: Path) -> Path:
        """Write NAME.npz, uncompressed, with `meta` as a JSON string; return its path."""
        folder.mkdir(parents=True, exist_ok=True)
        arrays = {name: getattr(self, name) for name in _ARRAYS}
        path = folder / f"{self.name}.npz"
        np.savez(path, meta=np.array(json.dumps(self.meta)), tick=self.tick, **arrays)
        return path


def make_qp_sequence(
    meta: dict[str, Any], ticks: Sequence[int], problems: Sequence[QpProblem]
) -> QpSequence:
    """Stack QPs of one size; bounds of NO_BOUND or more become infinite."""
    stacked = {name: np.stack([getattr(p, name) for p in problems]) for name in "HgAbClu"}
    stacked["l"][stacked["l"] <= -NO_BOUND] = -np.inf
    stacked["u"][stacked["u"] >= NO_BOUND] = np.inf
    tick = np.array(ticks, dtype=np.int64)
    return QpSequence({"format": FORMAT, **meta}, tick, **stacked)


def load_sequence(path: Path) -> QpSequence:
    """Read a sequence that save() wrote.

    Raises:
        Error: The file is not such a sequence.
    """
    try:
        with np.load(path, allow_pickle=False) as file:
            meta = json.loads(str(file["meta"]))
            arrays = {name: file[name] for name in _ARRAYS}
            tick = file["tick"]
    except (OSError, *CORRUPT_NPZ) as problem:
        raise Error(f"{path}: got {problem}, expected a sequence of QPs (.npz)") from None
    if meta.get("format") != FORMAT:
        raise Error(f"{path}: got the format {meta.get('format')!r}, expected '{FORMAT}'")
    return QpSequence(meta, tick, **arrays)
