"""The vendor's attitude filter, imitated: gyro integrated, tilt pulled toward gravity."""

from __future__ import annotations

from surefoot import _plant

MAHONY_GAIN = (
    0.5  # [1/s] slow: a push tilts the estimate little, a gyro bias tilts it by bias / GAIN
)


class MahonyFilter(_plant.MahonyFilter):
    """Complementary filter on SO(3) with GAIN; see bindings/src/plant/imu.hpp.

    Args:
        ax: Accelerometer at rest [m/s^2], IMU axes; the filter starts level with it, at yaw 0.
        ay: The same.
        az: The same.
    """

    def __init__(self, ax: float, ay: float, az: float) -> None:
        super().__init__((ax, ay, az), MAHONY_GAIN)
