"""What the plots show: the last seconds of a few numbers, with no peak left out."""

from __future__ import annotations

from collections import deque
from typing import NamedTuple

import numpy as np

from surefoot.geometry.rotations import Array

HISTORY_TIME = 10.0  # [s] that is kept
BUCKET_TIME = 0.04  # [s] that becomes one point


class TickMetrics(NamedTuple):
    """One control period in numbers.

    Attributes:
        position_error: Distance of the base from where it should be, as estimated [mm].
        angle_error: Angle between its attitude and the one it should have, as estimated [deg].
        torque_ratio: Greatest share of its limit that a motor's torque has.
        power: Sum of |torque times velocity| that the command takes [W].
        tick_us: Time from LowState to LowCmd [us].
    """

    position_error: float
    angle_error: float
    torque_ratio: float
    power: float
    tick_us: float


class Curves:
    """Keeps the greatest of each number in every 40 ms of the last 10 s."""

    def __init__(self) -> None:
        self._rows: deque[tuple[float, ...]] = deque(maxlen=round(HISTORY_TIME / BUCKET_TIME))
        self._bucket_max: Array | None = None
        self._bucket_end = BUCKET_TIME

    def add(self, time: float, sample: TickMetrics) -> None:
        """Add a control period that began at a time [s]; time never runs backwards."""
        row = np.array(sample)
        self._bucket_max = row if self._bucket_max is None else np.maximum(self._bucket_max, row)
        if time >= self._bucket_end - 1e-9:
            self._rows.append((time, *self._bucket_max.tolist()))
            self._bucket_max = None
            self._bucket_end = time + BUCKET_TIME

    def arrays(self) -> tuple[Array, ...]:
        """Return time [s] and each number of Sample, (n,) each."""
        rows = (
            np.array(list(self._rows))
            if self._rows
            else np.zeros((1, 1 + len(TickMetrics._fields)))
        )
        return tuple(rows.T)
