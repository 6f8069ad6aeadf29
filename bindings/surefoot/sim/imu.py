"""The IMU at its mount: exact, or with noise, bias and the vendor's attitude filter."""

from __future__ import annotations

from collections.abc import Sequence

import mujoco
import numpy as np

from surefoot.sim.attitude import MahonyFilter
from surefoot.sim.flaws import Flaws, draw_bias
from surefoot.sim.handles import Handles
from surefoot.sim.rotations import Array

GYRO_NOISE = 0.005  # [rad/s] standard deviation of a sample
GYRO_BIAS = 0.005  # [rad/s] constant, uniform in +- this
ACCELEROMETER_NOISE = 0.05  # [m/s^2]
ACCELEROMETER_BIAS = 0.05  # [m/s^2]
SAMPLE_PERIOD = 0.001  # [s] of the real IMU and its filter


class IdealImu:
    """Exact readings at the mount, lever arm included.

    MuJoCo's accelerometer tells of the physics step just taken, the others of this instant.

    Attributes:
        bias: (6,) zeros.
        gyro: (3,) [rad/s], IMU axes.
        accelerometer: (3,) specific force [m/s^2], IMU axes.
        quaternion: (4,) w, x, y, z: IMU to world.
    """

    def __init__(self, data: mujoco.MjData, handles: Handles) -> None:
        self.bias: Array = np.zeros(6)
        # Views into MuJoCo's memory: they follow it.
        self.gyro: Array = data.sensordata[handles.gyro]
        self.accelerometer: Array = data.sensordata[handles.accelerometer]
        self.quaternion: Sequence[float] | Array = data.sensordata[handles.quaternion]

    def start(self) -> None:
        """Begin; the robot is at rest."""

    def step(self) -> None:
        """Advance one physics step."""


class RealImu:
    """Readings with white noise and constant bias, sampled at 1 kHz, and a filtered attitude.

    Args:
        data: Where the exact readings come from.
        handles: Indices into it.
        dt: Physics step [s].
        rng: Draws biases and noise.
        flaws: What the biases are.

    Attributes:
        bias: (6,) of gyroscope [rad/s] and accelerometer [m/s^2], IMU axes; the truth, for judging.
        gyro: (3,) [rad/s], IMU axes.
        accelerometer: (3,) specific force [m/s^2], IMU axes.
        quaternion: (4,) w, x, y, z: IMU to world, the filter's; its yaw starts at 0 and drifts.
    """

    def __init__(
        self,
        data: mujoco.MjData,
        handles: Handles,
        dt: float,
        rng: np.random.Generator,
        flaws: Flaws,
    ) -> None:
        self._exact = IdealImu(data, handles)
        self._rng = rng
        self._steps = max(1, round(SAMPLE_PERIOD / dt))
        self._period = self._steps * dt
        self._count = 0
        gyro_bias = draw_bias(flaws.gyro_bias, GYRO_BIAS, rng)
        accelerometer_bias = draw_bias(flaws.accelerometer_bias, ACCELEROMETER_BIAS, rng)
        self.bias = np.concatenate([gyro_bias, accelerometer_bias])
        self._noise = np.repeat([GYRO_NOISE, ACCELEROMETER_NOISE], 3)
        self._reading = np.zeros(6)
        self._filter = MahonyFilter(0.0, 0.0, 9.81)

    @property
    def gyro(self) -> Array:
        """Latest sample (3,) [rad/s]."""
        return self._reading[:3]

    @property
    def accelerometer(self) -> Array:
        """Latest sample (3,) [m/s^2]."""
        return self._reading[3:]

    @property
    def quaternion(self) -> Sequence[float]:
        """Attitude filter's output w, x, y, z."""
        return self._filter.quaternion

    def start(self) -> None:
        """Start the filter from the resting accelerometer, its noise long averaged out."""
        rest = self._exact.accelerometer + self.bias[3:]
        self._filter = MahonyFilter(*rest.tolist())

    def step(self) -> None:
        """Advance one physics step; sample when the period is over."""
        self._count += 1
        if self._count % self._steps:
            return
        reading = self.bias + self._noise * self._rng.standard_normal(6)
        reading[:3] += self._exact.gyro
        reading[3:] += self._exact.accelerometer
        self._reading = reading
        gx, gy, gz, ax, ay, az = reading.tolist()
        self._filter.update((gx, gy, gz), (ax, ay, az), self._period)
