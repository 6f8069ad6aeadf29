"""Durations of calls, and how they are distributed."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np

PERCENTILES = {"min": 0.0, "p50": 50.0, "p90": 90.0, "p99": 99.0, "p99.9": 99.9, "max": 100.0}


def distribution(durations: list[int]) -> dict[str, float]:
    """Return n, and min, p50, p90, p99, p99.9 and max in us, of durations [ns]."""
    values = np.percentile(np.array(durations) / 1000.0, list(PERCENTILES.values()))
    numbers = {name: round(float(v), 3) for name, v in zip(PERCENTILES, values, strict=True)}
    return {"n": len(durations), **numbers}


@contextmanager
def without_garbage_collection() -> Iterator[None]:
    """Keep Python's garbage collector out of what is timed, as timeit does."""
    was_on = gc.isenabled()
    gc.collect()
    gc.disable()
    try:
        yield
    finally:
        if was_on:
            gc.enable()
