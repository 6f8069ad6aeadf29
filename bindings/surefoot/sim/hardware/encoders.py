"""Joint encoders: exact, or with the quantisation, velocity filter and noise of a motor driver."""

from __future__ import annotations

import math

import numpy as np

from surefoot import _plant

# [rad] Step of the measured angles. The encoder has 15 bits per rotor turn, as in Unitree's
# GO-M8010-6 (unitree_actuator_sdk). The gear ratio is 6, as of the hips and thighs of a go1
# (models/go1.toml). Joints with larger gear ratios have smaller steps.
POSITION_QUANTUM = 2.0 * math.pi / 2**15 / 6.0
# Assumed, because no data sheet states these values. Tests: test_plant_sensors.py.
VELOCITY_CUTOFF = 100.0  # [Hz] cut-off of the driver's first-order filter (delay 1.6 ms)
VELOCITY_NOISE = 0.05  # [rad/s] standard deviation of the white noise of every sample


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
