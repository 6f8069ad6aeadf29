"""Foot force sensors with an output in newtons, in raw counts, or without output."""

from __future__ import annotations

import math

import numpy as np

from surefoot import _plant
from surefoot.sim.hardware import walking_errors

# The vendor publishes no values. The offsets are those of unloaded feet in public logs of one Go1
# (8 to 48 counts); all other values are assumed. Tests: test_plant_sensors.py.
FORCE_NOISE = 3.0  # [N] standard deviation of footForceEst
COUNT_NOISE = 2.0  # [counts] standard deviation of footForce
COUNT_OFFSET = (5.0, 50.0)  # [counts] range of the uniform draw of footForce without load
COUNT_GAIN = (1.0, 2.0)  # [counts/N] range of the uniform draw of the gain
# [counts] Standard deviation of the random walk of the offset after one minute. In 95 % of all
# minutes, the offset changes by less than twice this value: 10 counts.
COUNT_DRIFT = 10.0 / 2.0


class FootSensors(_plant.FootSensors):
    """Converts normal forces to the int16 values of a LowState.

    Args:
        kind: "est" fills footForce and footForceEst, "raw" only footForce, "dead" neither.
        period: Time between samples [s].
        rng: Source of offsets, gains, drift and noise; None: exact newtons in both fields.
        walking_dt: Physics step [s] of sensors with walking errors: a larger gain, and forces that
            fall late; None: no walking errors.
    """

    def __init__(
        self,
        kind: str,
        period: float,
        rng: np.random.Generator | None,
        walking_dt: float | None = None,
    ) -> None:
        super().__init__(rng)
        self.counts_enabled, self.newtons_enabled = kind != "dead", kind == "est"
        if rng is not None:
            self.offset = rng.uniform(*COUNT_OFFSET, 4)
            gain = COUNT_GAIN if walking_dt is None else walking_errors.COUNT_GAIN
            self.gain = rng.uniform(*gain, 4)
            self.offset_walk = COUNT_DRIFT * math.sqrt(period / 60.0)
            self.count_noise, self.force_noise = COUNT_NOISE, FORCE_NOISE
            if walking_dt is not None:
                self.fall_blend = walking_errors.force_fall_blend(walking_dt)
