"""Errors of a real IMU: constant bias, white noise, and one sample per millisecond."""

from __future__ import annotations

import math

import numpy as np

from surefoot import _plant
from surefoot.geometry.rotations import Array
from surefoot.sim.flaws import Flaws, draw_bias
from surefoot.sim.hardware.attitude_filter import MAHONY_GAIN
from surefoot.sim.hardware.walking_errors import ACCELEROMETER_RANGE, GYRO_RANGE

# The values are assumed, because Unitree names no IMU and publishes no data sheet. Upper bounds are
# the limits of the arming checks (0.05 rad/s, 5 % of g): a healthy robot must pass these checks.
# For comparison: public logs of a Go1 have accelerometer offsets of 0.1 to 0.2 m/s^2, and
# benchmarks/estimation uses larger biases.
GYRO_NOISE = 0.005  # [rad/s] standard deviation of a sample
GYRO_BIAS = 0.005  # [rad/s] bound of the uniform draw of the constant bias
ACCELEROMETER_NOISE = 0.05  # [m/s^2] standard deviation of a sample
ACCELEROMETER_BIAS = 0.05  # [m/s^2] bound of the uniform draw of the constant bias
# [s] Period of the real IMU and its attitude filter: a real robot sends LowStates at 1 kHz.
SAMPLE_PERIOD = 0.001


def draw_imu_errors(
    flaws: Flaws, dt: float, rng: np.random.Generator, walking: bool = False
) -> tuple[_plant.ImuErrorModel, Array]:
    """Draw the errors of one IMU.

    Args:
        flaws: Flaws; their two biases set the errors, or how the errors are drawn.
        dt: Physics step [s].
        rng: Source of the biases, and later of the noise.
        walking: Whether values clip at the ranges of a real IMU.

    Returns:
        The error model, and the biases (6,) of gyroscope [rad/s] and accelerometer [m/s^2], IMU
        axes.
    """
    gyro_bias = draw_bias(flaws.gyro_bias, GYRO_BIAS, rng)
    accelerometer_bias = draw_bias(flaws.accelerometer_bias, ACCELEROMETER_BIAS, rng)
    steps = max(1, round(SAMPLE_PERIOD / dt))
    imu_errors = _plant.ImuErrorModel(
        gyro_bias,
        accelerometer_bias,
        GYRO_NOISE,
        ACCELEROMETER_NOISE,
        steps,
        steps * dt,
        MAHONY_GAIN,
        GYRO_RANGE if walking else math.inf,
        ACCELEROMETER_RANGE if walking else math.inf,
    )
    return imu_errors, np.concatenate([gyro_bias, accelerometer_bias])
