"""Model of the vendor's attitude filter: integrates the gyro and corrects tilt towards gravity."""

from __future__ import annotations

from surefoot import _plant

# [1/s] Gain of the tilt correction. Chosen, because the vendor's gain is not published. A push that
# causes a horizontal velocity v tilts the estimate by up to MAHONY_GAIN v / g. A gyro bias tilts
# the estimate by bias / MAHONY_GAIN.
MAHONY_GAIN = 0.5


class MahonyFilter(_plant.MahonyFilter):
    """Complementary filter on SO(3) with MAHONY_GAIN; see bindings/src/plant/imu.hpp.

    The filter starts with the tilt of an accelerometer sample at rest and with yaw 0.

    Args:
        ax: Accelerometer x at rest [m/s^2], IMU axes.
        ay: Accelerometer y at rest [m/s^2], IMU axes.
        az: Accelerometer z at rest [m/s^2], IMU axes.
    """

    def __init__(self, ax: float, ay: float, az: float) -> None:
        super().__init__((ax, ay, az), MAHONY_GAIN)
