"""Edges of the contact while walking: missed and extra ones, and delays of the estimate."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from estimation.log_rows import Array, Log
from estimation.recording import sample_rate

LOADED_SHARE = 0.05  # share of the weight above which a foot is loaded
MIN_PHASE_TIME = 0.020  # [s] shorter loaded or unloaded phases are no edges that must be found
MISSED_AFTER = 0.060  # [s] distance from which on an edge counts as missed
EXTRA_AFTER = 0.030  # [s] distance to any true crossing from which on an edge counts as extra


@dataclass
class EdgeScore:
    """Score of the estimated edges of some feet.

    Attributes:
        true: Number of true edges.
        missed: Number of true edges without an estimated edge of the same direction.
        extra: Number of estimated edges without a true crossing.
        touchdown: Delay of each found touchdown [s].
        liftoff: Delay of each found lift-off [s].
    """

    true: int = 0
    missed: int = 0
    extra: int = 0
    touchdown: list[float] = field(default_factory=list)
    liftoff: list[float] = field(default_factory=list)


def score_edges(log: Log, contact: Array, start: float) -> EdgeScore:
    """Compare the contact confidence (n, 4) with the true load from a time [s] on."""
    rate, score = sample_rate(log), EdgeScore()
    force = np.linalg.norm(log["truth_foot_forces"].reshape(-1, 4, 3), axis=2)
    loaded = force > LOADED_SHARE * log["weight"]
    for foot in range(4):
        _score_foot(loaded[:, foot], contact[:, foot] > 0.5, rate, start, score)
    return score


def _score_foot(
    loaded: Array, estimated: Array, rate: float, start: float, score: EdgeScore
) -> None:
    first, reach = round(start * rate), round(MISSED_AFTER * rate)
    long_phases = without_short_phases(loaded, round(MIN_PHASE_TIME * rate))
    free = set(_edges(estimated).tolist())
    for row in _edges(long_phases):
        if row < first:
            continue
        score.true += 1
        near = [k for k in free if abs(k - row) < reach and estimated[k] == long_phases[row]]
        if not near:
            score.missed += 1
            continue
        found = min(near, key=lambda k: abs(k - row))
        free.remove(found)
        delays = score.touchdown if long_phases[row] else score.liftoff
        delays.append((found - row) / rate)
    crossings, far = _edges(loaded), round(EXTRA_AFTER * rate)
    score.extra += sum(
        row >= first and np.abs(crossings - row).min(initial=len(loaded)) > far for row in free
    )


def _edges(on: Array) -> Array:
    return np.flatnonzero(np.diff(on.astype(np.int8))) + 1


def without_short_phases(on: Array, rows: int) -> Array:
    """Return on (n,) with phases of less than `rows` rows joined to the phase before them."""
    out = on.copy()
    ends = [0, *_edges(on).tolist(), len(on)]
    for start, end in pairwise(ends[1:]):
        if end - start < rows and end < len(on):
            out[start:end] = out[start - 1]
    return out
