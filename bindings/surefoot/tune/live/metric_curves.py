"""Data of the plots: the maximum of each metric in each 40 ms of the last 10 s."""

from __future__ import annotations

from collections import deque
from typing import NamedTuple

import numpy as np

from surefoot.geometry.rotations import Array

# Chosen for the page: 250 points on a plot of 330 pixels.
HISTORY_TIME = 10.0  # [s] duration of the kept history
BUCKET_TIME = 0.04  # [s] time that one plotted point covers


class TickMetrics(NamedTuple):
    """Metrics of one tick.

    Attributes:
        position_error: Distance of the estimated base from its reference position [mm].
        angle_error: Angle of the estimated base from its reference orientation [deg].
        torque_ratio: Largest ratio of torque magnitude to torque limit of the motors.
        power: Sum over the motors of the absolute product of commanded torque and velocity [W].
        tick_us: Time from LowState to LowCmd [us]. Simulation: CPU time of update(). Robot on UDP:
            median of the tick times.
    """

    position_error: float
    angle_error: float
    torque_ratio: float
    power: float
    tick_us: float


class Curves:
    """Maximum of each metric in each interval of 40 ms in the last 10 s; no peak is lost."""

    def __init__(self) -> None:
        self._rows: deque[tuple[float, ...]] = deque(maxlen=round(HISTORY_TIME / BUCKET_TIME))
        self._bucket_max: Array | None = None
        self._bucket_end = BUCKET_TIME

    def add(self, time: float, metrics: TickMetrics) -> None:
        """Add the metrics of a control period at a time [s]; times must not decrease."""
        row = np.array(metrics)
        self._bucket_max = row if self._bucket_max is None else np.maximum(self._bucket_max, row)
        if time >= self._bucket_end - 1e-9:
            self._rows.append((time, *self._bucket_max.tolist()))
            self._bucket_max = None
            self._bucket_end = time + BUCKET_TIME

    def arrays(self) -> tuple[Array, ...]:
        """Return the time [s] and the maxima of each field of TickMetrics, (n,) each."""
        rows = (
            np.array(list(self._rows))
            if self._rows
            else np.zeros((1, 1 + len(TickMetrics._fields)))
        )
        return tuple(rows.T)
