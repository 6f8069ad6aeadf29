"""Checks of the units and signs of accelerometer and gyroscope."""

from __future__ import annotations

import numpy as np

from surefoot._core import Error, Robot
from surefoot.estimate.checks.quaternion import quaternion_rotations
from surefoot.estimate.checks.torques import feet_are_loaded
from surefoot.estimate.checks.windows import (
    DEG_PER_RAD,
    MIN_ROTATION,
    MIN_WINDOWS,
    Windows,
    finite_median,
    unit_rows,
)
from surefoot.geometry.batch_rotations import Array, matrices_from_xyzw
from surefoot.sensor_log.sensor_log import SensorLog

GRAVITY = 9.81
# [rad/s] Rate above which the unit must be deg/s. Derived: the full scale of 2000 deg/s (assumed),
# 34.9 rad/s, plus 3 %.
GYRO_FULL_SCALE = 36.0
# Share of gravity below which the accelerometer shows free fall. Chosen: the median of a log with
# pushes and impacts is closer to 1, and a bias of 0.5 m/s^2 is 0.05.
FREE_FALL_SHARE = 0.3
# [s] Duration above which a log cannot be a free fall. Derived: a fall of 1 s is 4.9 m deep.
MAX_FREE_FALL = 1.0
# [rad] Smallest change of the accelerometer's tilt that counts as a rotation. Chosen: 3 deg, larger
# than the noise of the averaged acceleration. The gyroscope must show such a rotation too.
MIN_TILT = 0.05


def check_accelerometer(robot: Robot, log: SensorLog) -> list[str]:
    """Compare the median of the accelerometer with gravity; return warnings.

    Raises:
        Error: The accelerometer has a wrong unit, or lacks gravity although the robot stands.
    """
    values = log.columns["accelerometer"]
    norm = float(finite_median(np.linalg.norm(values, axis=1, keepdims=True))[0])
    # Chosen: at rest the norm is 1 g except for scale errors; 9.81 is far outside this range.
    for unit, one in (("g", 1.0), ("milli-g", 1000.0)):
        if 0.8 * one < norm < 1.25 * one:
            raise Error(
                f"{log.source}: column 'accelerometer': got a median size of {norm:.3g}, expected "
                f"about {GRAVITY} m/s^2: it seems to be in {unit}"
            )
    if norm == 0.0:
        return ["accelerometer is zero most of the time"]
    if norm < FREE_FALL_SHARE * GRAVITY and _cannot_fall(robot, log):
        raise Error(
            f"{log.source}: column 'accelerometer': got a median size of {norm:.3g} m/s^2, "
            f"expected about {GRAVITY}: it seems to lack gravity; log the specific force, + g "
            "upwards at rest"
        )
    # Chosen: the median over a log with pushes is closer to 1 g than this.
    if not 0.7 * GRAVITY < norm < 1.4 * GRAVITY:
        return [f"accelerometer has a median size of {norm:.3g} m/s^2, expected about {GRAVITY}"]
    w, x, y, z = robot.config.quat_base_imu
    specific_force = matrices_from_xyzw(np.array([[x, y, z, w]]))[0] @ finite_median(values)
    if specific_force[2] < -0.7 * GRAVITY:
        return ["accelerometer: the robot lies on its back, or the sign is wrong"]
    return []


def _cannot_fall(robot: Robot, log: SensorLog) -> bool:
    """Return whether the log is longer than a free fall, or its torques show loaded feet."""
    duration = float(np.ptp(log.time[np.isfinite(log.time)]))
    return duration > MAX_FREE_FALL or feet_are_loaded(robot, log, np.arange(log.rows))


def check_gyroscope_unit(log: SensorLog) -> None:
    """Compare the largest rates of the gyroscope with its range.

    Raises:
        Error: The gyroscope seems to be in deg/s.
    """
    size = np.linalg.norm(log.columns["gyroscope"], axis=1)
    size = size[np.isfinite(size)]
    if len(size) and np.percentile(size, 99.0) > GYRO_FULL_SCALE:
        raise Error(
            f"{log.source}: column 'gyroscope': got {np.percentile(size, 99.0):.3g} or more in "
            f"1 % of the rows, expected up to {GYRO_FULL_SCALE:g} rad/s: it seems to be in deg/s"
        )


def check_gyroscope_rotation(log: SensorLog, windows: Windows) -> list[str]:
    """Compare the gyroscope with the rotation of the quaternion; return warnings.

    If the log has no valid quaternion, the rotation of gravity in the accelerometer replaces it.
    The robot must not walk: its acceleration would look like a rotation of gravity.

    Raises:
        Error: The gyroscope has a wrong unit or sign.
    """
    if len(windows) == 0:
        return []
    other_rotations = quaternion_rotations(log, windows)
    if other_rotations is not None:
        return _compare(log, windows.gyro_rotation, other_rotations, MIN_ROTATION, "quaternion")
    return _compare(log, *_tilt_rotations(windows), MIN_TILT, "accelerometer")


def _tilt_rotations(windows: Windows) -> tuple[Array, Array]:
    """Return the tilts (n, 3) [rad] over 0.5 s: from the gyroscope, and from the accelerometer."""
    span = 5
    if len(windows) <= span:
        return np.zeros((0, 3)), np.zeros((0, 3))
    up = unit_rows(windows.mean_acceleration)
    total = np.cumsum(windows.gyro_rotation, axis=0)
    gyro_rotations = total[span:] - total[:-span]
    axis = up[span:]
    gyro_rotations = gyro_rotations - axis * np.sum(
        axis * gyro_rotations, axis=1, keepdims=True
    )  # the accelerometer does not measure yaw
    return gyro_rotations, np.cross(up[:-span], up[span:])


def _compare(
    log: SensorLog, gyro_rotations: Array, other_rotations: Array, threshold: float, other: str
) -> list[str]:
    size = np.linalg.norm(other_rotations, axis=1)
    rotating = size > threshold
    gyro_while_still = np.linalg.norm(gyro_rotations[~rotating], axis=1)
    if rotating.sum() >= MIN_WINDOWS:
        ratio = float(np.median(np.linalg.norm(gyro_rotations[rotating], axis=1) / size[rotating]))
        if 0.5 * DEG_PER_RAD < ratio < 2.0 * DEG_PER_RAD:
            raise Error(
                f"{log.source}: column 'gyroscope': got rotations {ratio:.1f} times those of "
                f"the {other}, expected equal ones in rad/s: it seems to be in deg/s"
            )
        if not 0.5 < ratio < 2.0:
            return [f"gyroscope rotates {ratio:.2g} times as far as the {other}"]
    # Chosen: three times the smallest rotation that counts, MIN_ROTATION or MIN_TILT.
    elif len(gyro_while_still) >= MIN_WINDOWS and np.median(gyro_while_still) > 3.0 * threshold:
        rate = float(np.median(gyro_while_still))
        return [
            f"gyroscope rotates by {rate:.2g} rad per window while the {other} is at rest: is it "
            "biased or in deg/s?"
        ]
    return []
