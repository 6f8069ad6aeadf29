"""Statistics of the records that a solver's runs over a sequence wrote."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt

from surefoot.bench.solvers.raw_file import Records
from surefoot.bench.timing_statistics import PERCENTILES

NO_STATUS, SOLVED, FAILED = 0, 1, 2  # SolveStatus in benchmarks/solvers/adapter.hpp
# A solution is wrong if a residual exceeds this factor times the requested tolerance. The
# controller checks its own solutions with the same factor.
ACCEPT_FACTOR = 5.0
Bools = npt.NDArray[np.bool_]


def solver_statistics(records: Records, tolerance: float) -> dict[str, Any]:
    """Return counts and distributions as JSON values; times in us."""
    status = records["status"]
    reached = np.isfinite(status)
    correct = _is_correct(records, ACCEPT_FACTOR * tolerance)
    wrong = reached & ~correct
    return {
        "n": len(status),
        "wall_us": _percentiles(records["wall_ns"][reached] / 1000.0),
        "cpu_us": _percentiles(records["cpu_ns"][reached] / 1000.0),
        "iterations": _mean_max(records["iterations"][reached]),
        "allocations": _mean_max(records["allocations"][reached]),
        "failures": int(((status == FAILED) | ~reached).sum()),
        "not_reached": int((~reached).sum()),
        "no_status": int((status == NO_STATUS).sum()),
        "wrong": int(wrong.sum()),
        "said_solved_but_wrong": int((wrong & (status == SOLVED)).sum()),
        "said_failed_but_right": int((correct & (status == FAILED)).sum()),
        "worst": {
            name: _json_number(records[name][reached].max(initial=0.0))
            for name in ("primal", "dual", "gap", "distance")
        },
    }


def _is_correct(records: Records, accept: float) -> Bools:
    kinds = [records[name] <= accept for name in ("primal", "dual", "gap")]  # NaN gives False
    correct: Bools = np.logical_and.reduce(kinds)
    return correct


def _percentiles(values: npt.NDArray[np.float64]) -> dict[str, float | None]:
    if not len(values):
        return dict.fromkeys(PERCENTILES)
    found = np.percentile(values, list(PERCENTILES.values()))
    return {name: round(float(v), 3) for name, v in zip(PERCENTILES, found, strict=True)}


def _mean_max(values: npt.NDArray[np.float64]) -> dict[str, float | None]:
    if not len(values) or values.min() < 0.0:  # -1: the solver does not report this value
        return {"mean": None, "max": None}
    return {"mean": round(float(values.mean()), 3), "max": float(values.max())}


def _json_number(value: float) -> float | None:
    """Return a value with 3 digits; None for NaN and infinity, which JSON does not have."""
    return float(f"{value:.3g}") if math.isfinite(value) else None
