"""Foot force sensors: newtons, raw counts, or nothing."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from surefoot.sim.rotations import Array

Counts = npt.NDArray[np.int16]

FORCE_NOISE = 3.0  # [N] standard deviation of footForceEst
COUNT_NOISE = 2.0  # counts, standard deviation of footForce
COUNT_OFFSET = (5.0, 50.0)  # counts of an unloaded foot
COUNT_GAIN = (1.0, 2.0)  # counts per newton
COUNT_DRIFT = 10.0 / 2.0  # counts, standard deviation of the random walk after a minute


class FootSensors:
    """Turns normal forces into the int16 that a LowState carries.

    Args:
        kind: "est" fills both fields, "raw" footForce alone, "dead" none.
        period: Between readings [s].
        rng: Draws offsets, gains, drift and noise; None reads exact newtons in both fields.
    """

    def __init__(self, kind: str, period: float, rng: np.random.Generator | None) -> None:
        self._kind = kind
        self._rng = rng
        self._walk = COUNT_DRIFT * math.sqrt(period / 60.0)
        self._offset, self._gain = np.zeros(4), np.ones(4)
        if rng is not None:
            self._offset = rng.uniform(*COUNT_OFFSET, 4)
            self._gain = rng.uniform(*COUNT_GAIN, 4)

    def read(self, normal_forces: Array) -> tuple[Counts, Counts]:
        """Return footForce [counts] and footForceEst [N], int16 (4,), of forces (4,) [N]."""
        if self._kind == "dead":
            return np.zeros(4, np.int16), np.zeros(4, np.int16)
        raw, newtons = normal_forces, normal_forces
        if self._rng is not None:
            draws = self._rng.standard_normal((3, 4))
            self._offset = self._offset + self._walk * draws[0]
            raw = self._offset + self._gain * normal_forces + COUNT_NOISE * draws[1]
            newtons = normal_forces + FORCE_NOISE * draws[2]
        if self._kind == "raw":
            return _int16(raw), np.zeros(4, np.int16)
        return _int16(raw), _int16(newtons)


def _int16(values: Array) -> Counts:
    return np.clip(np.round(values), -32768, 32767).astype(np.int16)
