"""Hypotheses about a walking log: healthy, or one fault. Each is fitted by robust least squares.

A healthy robot has small errors: every parameter has a normal prior of the size that is common. A
fault releases the prior of one parameter, or exchanges legs, or delays the IMU.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from surefoot.estimate.checks.walking.gravity import gravity_equations
from surefoot.estimate.checks.walking.identities import (
    ACC_BIAS,
    CALF,
    GAIN,
    GYRO_BIAS,
    LOGGED,
    PARAMETERS,
    Equations,
    Order,
    feet_equations,
    force_equations,
)
from surefoot.estimate.checks.walking.imu_path import ImuIntegrals
from surefoot.estimate.checks.walking.leg_paths import LegPaths
from surefoot.estimate.checks.walking.stances import Stances
from surefoot.geometry.batch_rotations import Array

# Standard deviations of healthy parameters. Assumed, because the vendor gives no values: gains
# within a few percent [1], bias of the gyroscope [rad/s] as gain start_gyroscope_bias, bias of the
# accelerometer 2 % of gravity [m/s^2], calves [rad] zeroed by hand to a degree, all legs shorter by
# a centimetre.
HEALTHY = np.repeat([0.03, 0.02, 0.2, 0.02, 0.05], [3, 3, 3, 4, 1])
FREE = 50.0  # factor on the standard deviation of the parameters of a fault. Chosen: almost flat
OUTLIER = 3.0  # residual over RMS above which the weight falls (Huber)
ITERATIONS = 4  # of the weights. Chosen: the costs change by less than 0.1 in further ones
DELAYS = 0.001 * np.arange(-50, 51, 10)  # [s] delays of the IMU that are tried first
FINE_DELAYS = 0.001 * np.arange(-8, 9, 4)  # [s] added to the best of them
FAULTS = {
    **{f"gain {k}": [GAIN.start + k] for k in range(3)},
    "gyroscope bias": list(range(GYRO_BIAS.start, GYRO_BIAS.stop)),
    "accelerometer bias": list(range(ACC_BIAS.start, ACC_BIAS.stop)),
    **{f"calf {k}": [CALF.start + k] for k in range(4)},
}


@dataclass(frozen=True)
class Fit:
    """A fitted hypothesis.

    Attributes:
        fault: Key of FAULTS, "healthy", "order" or "delay".
        cost: Negative logarithm of the likelihood, up to a constant.
        x: (PARAMETERS,) parameters.
        sigma: (PARAMETERS,) standard deviations of x.
        rms: RMS of the residuals of each identity.
        order: Order of the legs.
        delay: Delay of the IMU against the legs [s].
    """

    fault: str
    cost: float
    x: Array
    sigma: Array
    rms: Array
    order: Order = LOGGED
    delay: float = 0.0


class WalkingEvidence:
    """Equations of a log for any order of legs and any delay."""

    def __init__(self, paths: LegPaths, stances: Stances, integrals: ImuIntegrals) -> None:
        self._paths, self._stances, self._integrals = paths, stances, integrals
        self._gravity = gravity_equations(paths, stances, integrals.at(paths.time))

    def fits(self) -> list[Fit]:
        """Return the fits of all hypotheses, the healthy one first."""
        equations = self._equations()
        fits = [fit("healthy", equations, HEALTHY)]
        for fault, columns in FAULTS.items():
            scale = HEALTHY.copy()
            scale[columns] *= FREE
            fits.append(fit(fault, equations, scale))
        orders = [(a, b, c, d) for a, b, c, d in itertools.permutations(LOGGED)][1:]
        order = min(orders, key=self._feet_cost)
        fits.append(fit("order", self._equations(order), HEALTHY, order))
        delay = 0.0
        for steps in (DELAYS, FINE_DELAYS):
            delay = float(min(delay + steps, key=self._force_cost))
        fits.append(fit("delay", self._equations(delay=delay), HEALTHY, delay=delay))
        return fits

    def _feet_cost(self, order: Order) -> float:
        imu = self._integrals.at(self._paths.time)
        return robust_rms(feet_equations(self._paths, self._stances, imu, order, False).y)

    def _force_cost(self, delay: float) -> float:
        imu = self._integrals.at(self._paths.time + delay)
        return robust_rms(force_equations(self._paths, self._stances, imu, LOGGED, False).y)

    def _equations(self, order: Order = LOGGED, delay: float = 0.0) -> list[Equations]:
        imu = self._integrals.at(self._paths.time + delay)
        arguments = (self._paths, self._stances, imu, order)
        return [feet_equations(*arguments), force_equations(*arguments), *self._gravity]


def fit(
    fault: str,
    equations: Sequence[Equations],
    scale: Array,
    order: Order = LOGGED,
    delay: float = 0.0,
) -> Fit:
    """Fit the parameters; `scale` (PARAMETERS,) are their standard deviations before the log."""
    x: Array = np.zeros(PARAMETERS)
    for _ in range(ITERATIONS):
        H = np.asarray(np.diag(scale**-2.0))
        g = np.zeros(PARAMETERS)
        for e in equations:
            residual = e.y + e.C @ x
            size = np.linalg.norm(residual, axis=1)
            noise = robust_rms(residual)
            huber = np.minimum(1.0, OUTLIER * noise / np.maximum(size, 1e-12))
            weight = np.sqrt(huber * e.count / max(len(size), 1)) / max(noise, 1e-12)
            C = (e.C * weight[:, None, None]).reshape(-1, PARAMETERS)
            H += C.T @ C
            g += C.T @ (e.y * weight[:, None]).ravel()
        x = np.asarray(-np.linalg.solve(H, g), dtype=np.float64)
    rms = np.array([robust_rms(e.y + e.C @ x) for e in equations])
    counts = np.array([e.count for e in equations])
    cost = float(counts @ np.log(np.maximum(rms, 1e-12)) + 0.5 * np.sum((x / scale) ** 2))
    sigma = np.sqrt(np.diag(np.linalg.inv(H)))
    return Fit(fault, cost, x, sigma, rms, order, delay)


def robust_rms(residual: Array) -> float:
    """Return the RMS of the rows (m, d), with outliers cut to OUTLIER times the RMS."""
    size = np.linalg.norm(residual, axis=1)
    if len(size) == 0:
        return 1.0
    bound = OUTLIER * np.sqrt(np.mean(np.minimum(size, OUTLIER * np.median(size)) ** 2))
    return float(np.sqrt(np.mean(np.minimum(size, bound) ** 2)))
