"""Checks of the quaternion: it must have the order w x y z and rotate from IMU to world."""

from __future__ import annotations

import numpy as np

from surefoot._core import Error
from surefoot.estimate.checks.windows import (
    MIN_WINDOWS,
    Windows,
    angles_between,
    unit_rows,
)
from surefoot.geometry.batch_rotations import Array, matrices_from_xyzw, rotation_vectors
from surefoot.sensor_log.sensor_log import SensorLog

# [deg] Angle between the verticals of quaternion and accelerometer. Above WRONG_TILT the quaternion
# contradicts the accelerometer; below RIGHT_TILT both agree. Chosen: larger than the 5 deg that
# attitude filters reach under acceleration, smaller than the 180 deg of a wrong component order.
WRONG_TILT, RIGHT_TILT = 20.0, 10.0
# Squared difference of the rotations of quaternion and gyroscope, as a share of the squared
# rotations of the gyroscope. Above the first value both sensors contradict each other; below the
# second they agree. Chosen: equal rotations give 0, unrelated rotations 1 or more.
WRONG_ROTATION_ERROR, RIGHT_ROTATION_ERROR = 0.5, 0.15
# [rad] Smallest rotation of a window that is compared: 0.1 rad/s. Chosen: five times the default
# bias of a gyroscope (0.02 rad/s).
_MIN_ROTATION = 0.01
# Allowed difference between the length of a quaternion and 1. Chosen: larger than the rounding of
# logs with two digits, smaller than the error of a quaternion in other units.
_NORM_TOLERANCE = 0.1


def check_quaternion(log: SensorLog, windows: Windows) -> list[str]:
    """Compare the quaternion with the accelerometer and the gyroscope; return warnings.

    The vertical of the quaternion must match the accelerometer, and its rotations must match the
    gyroscope.

    Raises:
        Error: Both sensors fit clearly better if the quaternion is read as x y z w or as world to
            IMU, or if the accelerometer has the opposite sign.
    """
    if "quaternion" not in log.columns or len(windows) == 0:
        return []
    first, second = (log.columns["quaternion"][rows] for rows in (windows.start, windows.end))
    lengths = np.linalg.norm(np.stack([first, second]), axis=2)
    unit = (np.abs(lengths - 1.0) < _NORM_TOLERANCE).all(axis=0)
    if not unit.any():
        # A robot without this field sends zeros. They need no warning: the estimator's verdict is
        # ZERO.
        return [] if np.all(lengths == 0.0) else ["quaternion is far from unit length"]
    first, second = first[unit], second[unit]
    up, turned = unit_rows(windows.mean_acceleration[unit]), windows.gyro_rotation[unit]
    readings = {
        "w x y z": (first[:, [1, 2, 3, 0]], second[:, [1, 2, 3, 0]]),
        "x y z w": (first, second),
        "world to IMU (or the gyroscope is reversed)": (
            _inverse(first),
            _inverse(second),
        ),
    }
    scores = {name: _score(*pair, up, turned) for name, pair in readings.items()}
    tilt, error = scores.pop("w x y z")
    if tilt > 180.0 - RIGHT_TILT and not error > WRONG_ROTATION_ERROR:
        raise Error(
            f"{log.source}: column 'accelerometer': got a vertical {tilt:.0f} deg from that "
            "of the quaternion, which agrees with the gyroscope; expected the specific force: + g "
            "upwards at rest"
        )
    for name, (other_tilt, other_error) in scores.items():
        by_gravity = (
            tilt > WRONG_TILT and other_tilt < RIGHT_TILT and not other_error > WRONG_ROTATION_ERROR
        )
        by_turns = (
            error > WRONG_ROTATION_ERROR
            and other_error < RIGHT_ROTATION_ERROR
            and other_tilt < WRONG_TILT
        )
        if by_gravity or by_turns:
            what = (
                f"a vertical {tilt:.0f} deg from that of the accelerometer"
                if by_gravity
                else "rotations that disagree with the gyroscope"
            )
            raise Error(
                f"{log.source}: column 'quaternion': got {what}, expected w x y z, IMU to world; "
                f"it fits if read as {name}"
            )
    return _warnings(tilt, error, first)


def quaternion_rotations(log: SensorLog, windows: Windows) -> Array | None:
    """Return the rotation vector of each window (w, 3) [rad]; None if not all have unit length."""
    if "quaternion" not in log.columns:
        return None
    pair = [
        log.columns["quaternion"][rows][:, [1, 2, 3, 0]] for rows in (windows.start, windows.end)
    ]
    lengths = np.linalg.norm(np.stack(pair), axis=2)
    if not np.all(np.abs(lengths - 1.0) < _NORM_TOLERANCE):
        return None
    return _rotations(*pair)


def _inverse(wxyz: Array) -> Array:
    return np.asarray(wxyz[:, [1, 2, 3, 0]] * [-1.0, -1.0, -1.0, 1.0])


def _rotations(first: Array, second: Array) -> Array:
    """Return the rotation vectors (n, 3) [rad] from `first` to `second`, in the axes of `first`.

    Both are (n, 4) quaternions x y z w.
    """
    R = np.swapaxes(matrices_from_xyzw(first), 1, 2) @ matrices_from_xyzw(second)
    return rotation_vectors(R)


def _score(first: Array, second: Array, up: Array, turned: Array) -> tuple[float, float]:
    """Return the median angle between verticals [deg], and the relative squared rotation error.

    The rotation error is NaN if too few windows rotate.
    """
    tilt = float(np.median(angles_between(matrices_from_xyzw(first)[:, 2, :], up)))
    rotating = np.linalg.norm(turned, axis=1) > _MIN_ROTATION
    if rotating.sum() < MIN_WINDOWS:
        return tilt, float("nan")
    squared_error = np.sum((_rotations(first, second)[rotating] - turned[rotating]) ** 2)
    return tilt, float(squared_error / np.sum(turned[rotating] ** 2))


def _warnings(tilt: float, error: float, wxyz: Array) -> list[str]:
    doubts = []
    if tilt > WRONG_TILT:
        doubts.append(f"quaternion: vertical {tilt:.0f} deg from that of the accelerometer")
    # (0, 0, 0, 1) may be a level robot with heading 0 whose quaternion has the order x y z w.
    elif not error < WRONG_ROTATION_ERROR and abs(wxyz[0, 0]) < 0.1 and abs(wxyz[0, 3]) > 0.99:
        doubts.append(
            "quaternion starts as 0 0 0 1: is it a heading of 180 deg, or the order x y z w?"
        )
    if error > WRONG_ROTATION_ERROR:
        doubts.append("quaternion: rotations disagree with the gyroscope")
    return doubts
