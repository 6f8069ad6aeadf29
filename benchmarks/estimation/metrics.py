"""Metrics of the benchmark: limits of the figures, and how the values of the seeds are merged."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from estimation.log_rows import Array

Values = dict[str, float]


@dataclass
class Result:
    """Result of one seed of one case.

    Attributes:
        values: Values by name of the figure; NaN if the estimator gives no value.
        series: Arrays (n,) by name, which are evaluated together with those of other seeds.
    """

    values: Values
    series: dict[str, Array] = field(default_factory=dict)


@dataclass(frozen=True)
class Metric:
    """Unit and limits of a figure.

    Attributes:
        unit: Unit as text.
        upper_limit: Largest value that passes. None: no limit.
        lower_limit: Smallest value that passes. None: no limit.
        summed: True if the values of the seeds are added; false for a percentile of the values.
    """

    unit: str
    upper_limit: float | None = None
    lower_limit: float | None = None
    summed: bool = False

    @property
    def limit_text(self) -> str:
        """Limit as text; empty if the figure has no limit."""
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

        The merged value is the sum (`summed`), the 5th percentile (with a lower limit) or else the
        95th percentile. It is NaN if any seed has NaN.
        """
        known = {seed: value for seed, value in values.items() if not math.isnan(value)}
        if len(known) < len(values):
            return math.nan, min(set(values) - set(known)), math.nan
        larger_is_worse = self.lower_limit is None
        worst = (max if larger_is_worse else min)(known, key=lambda seed: known[seed])
        values_of_seeds = list(known.values())
        got = (
            math.fsum(values_of_seeds)
            if self.summed
            else float(np.percentile(values_of_seeds, 95 if larger_is_worse else 5))
        )
        return got, worst, known[worst]


def find_metric(case: str, name: str) -> Metric:
    """Return the metric of a figure; a figure that is not in METRICS has no limit."""
    return METRICS.get(f"{case}/{name}") or METRICS.get(name.split(":")[0], Metric(""))


METRICS: dict[str, Metric] = {
    "fell": Metric("runs", upper_limit=0, summed=True),
    "quiet/height drift": Metric("mm", upper_limit=5),
    "quiet_long/height drift": Metric("mm", upper_limit=5),
    "false": Metric("transitions", upper_limit=0, summed=True),
    "velocity RMSE": Metric("m/s", upper_limit=0.02),
    "velocity RMSE per axis": Metric("m/s"),
    "tilt RMSE": Metric("deg"),
    "tilt RMSE beyond bias": Metric("deg", upper_limit=0.3),
    "force RMSE": Metric("% of weight", upper_limit=8),
    "NIS in band": Metric("% of ticks", lower_limit=90),
    "NEES in band": Metric("% of ticks", lower_limit=90),
    "NIS mean": Metric("per dof"),
    "NEES mean": Metric("per dof"),
    "transitions": Metric("", summed=True),
    "missed": Metric("transitions", upper_limit=0, summed=True),
    "delay max": Metric("ms", upper_limit=20),
    "delay p95": Metric("ms", upper_limit=20),
    "calibration error": Metric("", upper_limit=0.1),
    "tilted quaternion": Metric("s", upper_limit=1),
    "moving start": Metric("s", upper_limit=1),
    "speed at start": Metric("m/s"),
    "frozen IMU, velocity error": Metric("m/s", upper_limit=0.1),
    "doubled accelerometer, velocity RMSE": Metric("m/s", upper_limit=0.02),
    "lost rows, velocity error": Metric("m/s", upper_limit=0.1),
    "velocity RMSE at the end": Metric("m/s", upper_limit=0.02),
    "gyro bias error": Metric("rad/s", upper_limit=0.002),
    "vertical bias error": Metric("m/s^2", upper_limit=0.03),
    "horizontal bias sigma, still": Metric("m/s^2", lower_limit=0.08),
    "horizontal bias error, moved": Metric("m/s^2", upper_limit=0.05),
    "reached": Metric("deg", lower_limit=None),
    "height error": Metric("mm", upper_limit=5),
    "tilt error": Metric("deg", upper_limit=0.5),
    "mass error": Metric("%", upper_limit=10),
    "11 kg, height error": Metric("mm", upper_limit=20),
    "greatest payload": Metric("kg"),
}
