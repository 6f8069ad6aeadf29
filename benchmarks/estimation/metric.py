"""Unit and limits of a figure, and how the values of the seeds are merged."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from estimation.log_rows import Array

MERGES: dict[str, Callable[[Array], float]] = {
    "sum": lambda values: math.fsum(values),
    "mean": lambda values: float(np.mean(values)),
    "median": lambda values: float(np.median(values)),
    "max": lambda values: float(np.max(values)),
    "rms": lambda values: float(np.sqrt(np.mean(np.square(values)))),
}


@dataclass(frozen=True)
class Metric:
    """Unit and limits of a figure.

    Attributes:
        unit: Unit as text.
        upper_limit: Largest value that passes. None: no limit.
        lower_limit: Smallest value that passes. None: no limit.
        merged: How the values of the seeds are merged, a key of MERGES. "percentile": the 95th
            percentile, or the 5th of a figure with only a lower limit.
    """

    unit: str
    upper_limit: float | None = None
    lower_limit: float | None = None
    merged: str = "percentile"

    @property
    def limit_text(self) -> str:
        """Limit as text; empty if the figure has no limit."""
        if self.upper_limit is not None and self.lower_limit is not None:
            return f"{self.lower_limit:g} .. {self.upper_limit:g}"
        if self.upper_limit is not None:
            return f"<= {self.upper_limit:g}"
        return "" if self.lower_limit is None else f">= {self.lower_limit:g}"

    def passes(self, value: float) -> bool | None:
        """Return whether a value is within the limits; None if there is no limit."""
        if self.upper_limit is None and self.lower_limit is None:
            return None
        low = -math.inf if self.lower_limit is None else self.lower_limit
        high = math.inf if self.upper_limit is None else self.upper_limit
        return low <= value <= high

    def merge(self, values: dict[int, float]) -> tuple[float, int, float]:
        """Return the merged value of all seeds, the worst seed, and the value of the worst seed.

        The merged value is NaN if any seed has NaN.
        """
        known = {seed: value for seed, value in values.items() if not math.isnan(value)}
        if len(known) < len(values):
            return math.nan, min(set(values) - set(known)), math.nan
        larger_is_worse = self.lower_limit is None or self.upper_limit is not None
        worst = (max if larger_is_worse else min)(known, key=lambda seed: known[seed])
        of_seeds = np.array(list(known.values()))
        if self.merged == "percentile":
            got = float(np.percentile(of_seeds, 95 if larger_is_worse else 5))
        else:
            got = MERGES[self.merged](of_seeds)
        return got, worst, known[worst]
