"""Integrals of gyroscope and accelerometer on the grid of the leg paths, with a delay."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from surefoot._core import Robot
from surefoot.estimate.checks.walking.samples import finite_samples, interpolated
from surefoot.geometry.batch_rotations import Array, matrices_from_xyzw
from surefoot.sensor_log.sensor_log import SensorLog


@dataclass(frozen=True)
class ImuPath:
    """Integrals of the IMU's samples, base axes.

    Attributes:
        rotation: (n, 3) integral of the gyroscope [rad].
        position: (n, 3) second integral of the accelerometer without its running mean [m].
        mean_force: (n, 3) running mean of the accelerometer [m/s^2].
    """

    rotation: Array
    position: Array
    mean_force: Array


class ImuIntegrals:
    """Integrals of the IMU of a log, which are read at any times.

    Args:
        robot: Robot, for the axes of its IMU.
        log: The log.
        mean_time: Duration of the running mean [s].
    """

    def __init__(self, robot: Robot, log: SensorLog, mean_time: float) -> None:
        w, x, y, z = robot.config.quat_base_imu
        R = matrices_from_xyzw(np.array([[x, y, z, w]]))[0]
        self._time, samples = finite_samples(log, "gyroscope", "accelerometer")
        omega, force = (values @ R.T for values in samples)
        self._rotation = self._integral(omega)
        velocity = self._integral(force)
        early = np.maximum(self._time - 0.5 * mean_time, self._time[0])
        late = np.minimum(self._time + 0.5 * mean_time, self._time[-1])
        change = interpolated(late, self._time, velocity) - interpolated(
            early, self._time, velocity
        )
        self._mean = change / np.maximum(late - early, 1e-9)[:, None]
        self._position = self._integral(self._integral(force - self._mean))

    def at(self, time: Array) -> ImuPath:
        """Return the integrals at times (n,) [s]."""
        integrals = (self._rotation, self._position, self._mean)
        return ImuPath(*(interpolated(time, self._time, values) for values in integrals))

    def _integral(self, values: Array) -> Array:
        """Integrate rows (n, 3) by the trapezoidal rule."""
        steps = np.diff(self._time)[:, None] * 0.5 * (values[1:] + values[:-1])
        return np.concatenate([np.zeros((1, 3)), np.cumsum(steps, axis=0)])
