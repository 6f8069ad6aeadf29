"""Joint encoders: exact, or quantised and differentiated as a motor driver does it."""

from __future__ import annotations

import math

import numpy as np

from surefoot.sim.rotations import Array

POSITION_QUANTUM = 2.0 * math.pi / 2**15 / 6.0  # [rad] 15 bits a rotor turn, gear ratio 6
VELOCITY_CUTOFF = 100.0  # [Hz] of the driver's first-order filter: 1.6 ms of delay
VELOCITY_NOISE = 0.05  # [rad/s] standard deviation


class IdealEncoders:
    """Exact angles and velocities."""

    def step(self, dq: Array) -> None:
        """Advance one physics step."""

    def read(self, q: Array, dq: Array) -> tuple[Array, Array]:
        """Return angles (12,) [rad] and velocities (12,) [rad/s]."""
        return q, dq


class RealEncoders:
    """Quantised angles; velocities low-passed at 100 Hz with white noise on top.

    Args:
        dt: Physics step [s].
        rng: Draws the noise.
    """

    def __init__(self, dt: float, rng: np.random.Generator) -> None:
        self._share = -math.expm1(-2.0 * math.pi * VELOCITY_CUTOFF * dt)
        self._filtered = np.zeros(12)
        self._rng = rng

    def step(self, dq: Array) -> None:
        """Advance the filter one physics step with the true velocities (12,) [rad/s]."""
        self._filtered += self._share * (dq - self._filtered)

    def read(self, q: Array, dq: Array) -> tuple[Array, Array]:
        """Return angles (12,) [rad] and velocities (12,) [rad/s]; `dq` went into step()."""
        angles = np.round(q / POSITION_QUANTUM) * POSITION_QUANTUM
        return angles, self._filtered + VELOCITY_NOISE * self._rng.standard_normal(12)
