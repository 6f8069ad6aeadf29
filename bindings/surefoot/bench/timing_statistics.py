"""Statistics of the durations of calls."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np
import numpy.typing as npt

from surefoot.bench.tick_program import Series

PERCENTILES = {"min": 0.0, "p50": 50.0, "p90": 90.0, "p99": 99.0, "p99.9": 99.9, "max": 100.0}
# [us] The period of each control rate. A tick that takes longer is missed.
DEADLINES = {"500Hz": 2000.0, "1kHz": 1000.0}
# [us] Start of the last bin, which counts all longer durations. Chosen: a quarter of the period at
# 500 Hz.
HISTOGRAM_END = 500


def distribution(durations: npt.ArrayLike) -> dict[str, float]:
    """Return the number n, and min, p50, p90, p99, p99.9, max of durations [us]."""
    values = np.asarray(durations, dtype=float)
    numbers = np.percentile(values, list(PERCENTILES.values()))
    return {
        "n": len(values),
        **{k: round(float(v), 3) for k, v in zip(PERCENTILES, numbers, strict=True)},
    }


def histogram(durations: npt.ArrayLike) -> list[int]:
    """Return the counts of durations [us] in bins of 1 us, up to the last non-empty bin."""
    bins = np.minimum(np.asarray(durations, dtype=float), HISTOGRAM_END).astype(int)
    return [int(count) for count in np.bincount(bins)]


def slowest_tick(durations: npt.NDArray[np.float32], ticks_per_pass: int) -> float:
    """Return the duration of the slowest tick of the recording [us].

    The duration of each tick is its median over all passes. The machine causes most of the longest
    single durations. A tick that is slow in most passes is slow because of the controller.
    """
    return round(float(np.median(durations.reshape(-1, ticks_per_pass), axis=0).max()), 3)


def series_statistics(series: Series, ticks_per_pass: int) -> dict[str, Any]:
    """Return the figures of a series as JSON values.

    A series without CPU times has only the figures of the wall time.

    Args:
        series: Timings of one kind of call.
        ticks_per_pass: Number of ticks per pass over the recording.
    """
    figures: dict[str, Any] = {
        "wall_us": distribution(series.wall),
        "slowest_us": slowest_tick(series.wall, ticks_per_pass),
    }
    if series.cpu is None:
        return figures
    iterations = Counter(series.iterations.tolist())
    return {
        **figures,
        "cpu_us": distribution(series.cpu),
        "missed": {name: int((series.wall > us).sum()) for name, us in DEADLINES.items()},
        "histogram_us": histogram(series.wall),
        "iterations": {str(k): iterations[k] for k in sorted(iterations)},
        "failures": series.failures,
        "walking": series.walking,
        "allocations": series.allocations,
        "page_faults": series.page_faults,
        "first_pass": {
            "allocations": series.first_allocations,
            "page_faults": series.first_page_faults,
        },
    }
