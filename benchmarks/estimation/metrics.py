"""Every figure once: what is asked of it, and how the seeds' values become one."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from estimation.log_rows import Array

Values = dict[str, float]


@dataclass
class Result:
    """What one seed of one case gave.

    Attributes:
        values: By figure's name; NaN is "the estimator said nothing".
        series: Arrays (n,) by name that only make sense together with those of other seeds.
    """

    values: Values
    series: dict[str, Array] = field(default_factory=dict)


@dataclass(frozen=True)
class Metric:
    """What is asked.

    Attributes:
        unit: For people.
        upper_limit: Greatest value that passes; None if there is no such.
        lower_limit: Least value that passes.
        summed: Whether seeds' values are added, instead of their percentile taken.
    """

    unit: str
    upper_limit: float | None = None
    lower_limit: float | None = None
    summed: bool = False

    @property
    def limit_text(self) -> str:
        """What passes, in words; empty if the figure is told only."""
        if self.upper_limit is not None:
            return f"<= {self.upper_limit:g}"
        return "" if self.lower_limit is None else f">= {self.lower_limit:g}"

    def passes(self, value: float) -> bool | None:
        """Whether a value does; None if nothing is asked."""
        if self.upper_limit is None and self.lower_limit is None:
            return None
        low = -math.inf if self.lower_limit is None else self.lower_limit
        high = math.inf if self.upper_limit is None else self.upper_limit
        return low <= value <= high

    def merge(self, values: dict[int, float]) -> tuple[float, int, float]:
        """Return the value of all seeds, the worst seed and its value.

        The value is the sum, or the 95th percentile, the 5th where more is better.
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
    """Return what is asked of a figure; one that is not in the table is told only."""
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
