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
class Figure:
    """What is asked.

    Attributes:
        unit: For people.
        most: Greatest value that passes; None if there is no such.
        least: Least value that passes.
        total: Whether seeds' values are added, instead of their percentile taken.
    """

    unit: str
    most: float | None = None
    least: float | None = None
    total: bool = False

    @property
    def asked(self) -> str:
        """What passes, in words; empty if the figure is told only."""
        if self.most is not None:
            return f"<= {self.most:g}"
        return "" if self.least is None else f">= {self.least:g}"

    def passes(self, value: float) -> bool | None:
        """Whether a value does; None if nothing is asked."""
        if self.most is None and self.least is None:
            return None
        low = -math.inf if self.least is None else self.least
        high = math.inf if self.most is None else self.most
        return low <= value <= high

    def merge(self, values: dict[int, float]) -> tuple[float, int, float]:
        """Return the value of all seeds, the worst seed and its value.

        The value is the sum, or the 95th percentile, the 5th where more is better.
        """
        known = {seed: value for seed, value in values.items() if not math.isnan(value)}
        if len(known) < len(values):
            return math.nan, min(set(values) - set(known)), math.nan
        upwards = self.least is None
        worst = (max if upwards else min)(known, key=lambda seed: known[seed])
        every = list(known.values())
        got = math.fsum(every) if self.total else float(np.percentile(every, 95 if upwards else 5))
        return got, worst, known[worst]


def find(case: str, name: str) -> Figure:
    """Return what is asked of a figure; one that is not in the table is told only."""
    return FIGURES.get(f"{case}/{name}") or FIGURES.get(name.split(":")[0], Figure(""))


FIGURES: dict[str, Figure] = {
    "fell": Figure("runs", most=0, total=True),
    "quiet/height drift": Figure("mm", most=5),
    "quiet_long/height drift": Figure("mm", most=5),
    "false": Figure("transitions", most=0, total=True),
    "velocity RMSE": Figure("m/s", most=0.02),
    "velocity RMSE per axis": Figure("m/s"),
    "tilt RMSE": Figure("deg"),
    "tilt RMSE beyond bias": Figure("deg", most=0.3),
    "force RMSE": Figure("% of weight", most=8),
    "NIS in band": Figure("% of ticks", least=90),
    "NEES in band": Figure("% of ticks", least=90),
    "NIS mean": Figure("per dof"),
    "NEES mean": Figure("per dof"),
    "transitions": Figure("", total=True),
    "missed": Figure("transitions", most=0, total=True),
    "delay max": Figure("ms", most=20),
    "delay p95": Figure("ms", most=20),
    "calibration error": Figure("", most=0.1),
    "tilted quaternion": Figure("s", most=1),
    "moving start": Figure("s", most=1),
    "speed at start": Figure("m/s"),
    "frozen IMU, velocity error": Figure("m/s", most=0.1),
    "doubled accelerometer, velocity RMSE": Figure("m/s", most=0.02),
    "lost rows, velocity error": Figure("m/s", most=0.1),
    "velocity RMSE at the end": Figure("m/s", most=0.02),
    "gyro bias error": Figure("rad/s", most=0.002),
    "vertical bias error": Figure("m/s^2", most=0.03),
    "horizontal bias sigma, still": Figure("m/s^2", least=0.08),
    "horizontal bias error, moved": Figure("m/s^2", most=0.05),
    "reached": Figure("deg", least=None),
    "height error": Figure("mm", most=5),
    "tilt error": Figure("deg", most=0.5),
    "mass error": Figure("%", most=10),
    "11 kg, height error": Figure("mm", most=20),
    "greatest payload": Figure("kg"),
}
