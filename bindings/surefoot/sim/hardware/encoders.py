"""Joint encoders: exact, or with the quantisation, velocity filter and noise of a motor driver."""

from __future__ import annotations

import math

import numpy as np

from surefoot import _plant

POSITION_QUANTUM = 2.0 * math.pi / 2**15 / 6.0  # [rad] 15 bits per rotor turn, gear ratio 6
VELOCITY_CUTOFF = 100.0  # [Hz] of the driver's first-order filter; its delay is 1.6 ms
VELOCITY_NOISE = 0.05  # [rad/s] standard deviation


class IdealEncoders(_plant.Encoders):
    """Exact angles and velocities."""

    def __init__(self) -> None:
        super().__init__(0.0, 1.0, 0.0, None)


class RealEncoders(_plant.Encoders):
    """Quantised angles; velocities low-passed at 100 Hz, with white noise added.

    Args:
        dt: Physics step [s].
        rng: Source of the noise.
    """

    def __init__(self, dt: float, rng: np.random.Generator) -> None:
        filter_blend = -math.expm1(-2.0 * math.pi * VELOCITY_CUTOFF * dt)
        super().__init__(POSITION_QUANTUM, filter_blend, VELOCITY_NOISE, rng)
