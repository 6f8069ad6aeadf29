"""The vendor's attitude filter, imitated: gyro integrated, tilt pulled toward gravity."""

from __future__ import annotations

import math

GAIN = 0.5  # [1/s] slow: a push tilts the estimate little, a gyro bias tilts it by bias / GAIN


class MahonyFilter:
    """Complementary filter on SO(3); yaw is integrated only, so it drifts.

    Source: R. Mahony, T. Hamel, J.-M. Pflimlin, "Nonlinear complementary filters on the special
    orthogonal group", IEEE TAC 53(5), 2008, the explicit filter without bias estimate.

    Attributes:
        quaternion: w, x, y, z: IMU to world.
    """

    def __init__(self, ax: float, ay: float, az: float) -> None:
        """Start level with an accelerometer reading at rest [m/s^2], facing yaw 0."""
        roll, pitch = math.atan2(ay, az), math.atan2(-ax, math.hypot(ay, az))
        cr, sr = math.cos(roll / 2), math.sin(roll / 2)
        cp, sp = math.cos(pitch / 2), math.sin(pitch / 2)
        self.quaternion = (cr * cp, sr * cp, cr * sp, -sr * sp)

    def update(
        self, gyro: tuple[float, float, float], accel: tuple[float, float, float], dt: float
    ) -> None:
        """Advance by dt [s] with gyro [rad/s] and specific force [m/s^2], both in IMU axes."""
        w, x, y, z = self.quaternion
        gx, gy, gz = gyro
        ax, ay, az = accel
        norm = math.sqrt(ax * ax + ay * ay + az * az)
        if norm > 1e-6:
            # Correction: measured up x estimated up, both in IMU axes.
            ux, uy, uz = 2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)
            gain = GAIN / norm
            gx += gain * (ay * uz - az * uy)
            gy += gain * (az * ux - ax * uz)
            gz += gain * (ax * uy - ay * ux)
        h = 0.5 * dt
        w, x, y, z = (
            w - h * (x * gx + y * gy + z * gz),
            x + h * (w * gx + y * gz - z * gy),
            y + h * (w * gy - x * gz + z * gx),
            z + h * (w * gz + x * gy - y * gx),
        )
        scale = 1.0 / math.sqrt(w * w + x * x + y * y + z * z)
        self.quaternion = (w * scale, x * scale, y * scale, z * scale)
