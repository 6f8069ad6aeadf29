"""Flaws of one robot, set or drawn with the seed: IMU biases, torque errors, trunk mass."""

from __future__ import annotations

from dataclasses import dataclass
from statistics import NormalDist

import numpy as np

from surefoot._core import Error
from surefoot.geometry.rotations import Array
from surefoot.robot.setting_checks import check_number

Bias = tuple[float, float, float] | float | None


@dataclass(frozen=True)
class Flaws:
    """Differences of one robot from its model.

    The first four attributes have an effect only with real sensors. A bias is given as three
    numbers (the bias in IMU axes), as one number (the standard deviation of a normal draw per
    axis), or as None (the default uniform draw of the IMU).

    Attributes:
        gyro_bias: Gyroscope bias [rad/s].
        accelerometer_bias: Accelerometer bias [m/s^2].
        torque_error: Bound e of the constant relative torque error of each motor, which is drawn
            uniformly from -e to e.
        torque_scale: Additional factor on the torques of all motors, like a wrong torque constant.
        trunk_mass_scale: Factor on the trunk's mass and inertia.
        trunk_com_shift: Shift of the trunk's centre of mass, base frame [m].
    """

    gyro_bias: Bias = None
    accelerometer_bias: Bias = None
    torque_error: float = 0.05  # assumed; docs/reference/virtual-robot.md states it
    torque_scale: float = 1.0
    trunk_mass_scale: float = 1.0
    trunk_com_shift: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        _check_bias("gyro_bias", self.gyro_bias, 1.0)
        _check_bias("accelerometer_bias", self.accelerometer_bias, 10.0)
        check_number("torque_error", self.torque_error, 0.0, 0.9)
        check_number("torque_scale", self.torque_scale, 0.0, 10.0)
        check_number("trunk_mass_scale", self.trunk_mass_scale, 0.01, 100.0)
        _check_vector("trunk_com_shift", self.trunk_com_shift, 1.0)


def draw_bias(bias: Bias, half_width: float, rng: np.random.Generator) -> Array:
    """Return a bias (3,) in IMU axes.

    Every call draws three numbers from `rng`, so later draws do not depend on the form of the bias.

    Args:
        bias: The bias, in one of the three forms of Flaws.
        half_width: Bound of the uniform draw if `bias` is None, in the unit of the bias.
        rng: Source of random numbers.
    """
    uniform = rng.uniform(-1.0, 1.0, 3)
    if bias is None:
        return half_width * uniform
    if isinstance(bias, tuple):
        return np.array(bias)
    return np.array([bias * NormalDist().inv_cdf((1.0 + float(u)) / 2.0) for u in uniform])


def _check_bias(name: str, bias: Bias, maximum: float) -> None:
    if bias is None:
        return
    if isinstance(bias, tuple):
        _check_vector(name, bias, maximum)
    else:
        check_number(name, bias, 0.0, maximum)


def _check_vector(name: str, values: tuple[float, ...], maximum: float) -> None:
    if not isinstance(values, tuple) or len(values) != 3:
        raise Error(f"{name}: got {values!r}, expected x, y, z")
    for value in values:
        check_number(name, value, -maximum, maximum)
