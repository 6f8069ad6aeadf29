"""Conversions of rotations with quaternions w x y z, the order of MuJoCo and the SDK."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]


def matrix_from_wxyz(quaternion: npt.ArrayLike) -> Array:
    """Return the rotation matrix (3, 3) of a unit quaternion w x y z."""
    w, x, y, z = (float(c) for c in np.asarray(quaternion))
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def rpy_from_wxyz(quaternion: npt.ArrayLike) -> tuple[float, float, float]:
    """Return roll, pitch, yaw [rad] of a unit quaternion: R = Rz(yaw) Ry(pitch) Rx(roll)."""
    w, x, y, z = (float(c) for c in np.asarray(quaternion))
    roll = math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))
    pitch = math.asin(max(-1.0, min(1.0, 2 * (w * y - z * x))))
    yaw = math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
    return roll, pitch, yaw


def wxyz_from_rotation_vector(vector: npt.ArrayLike) -> Array:
    """Return the quaternion w x y z of a rotation vector (3,) [rad]."""
    vector = np.asarray(vector, dtype=float)
    angle = float(np.linalg.norm(vector))
    if angle < 1e-12:
        return np.array([1.0, 0.0, 0.0, 0.0])
    return np.concatenate([[math.cos(angle / 2)], math.sin(angle / 2) * vector / angle])


def slope_quaternion(slope_deg: float, heading_deg: float) -> Array:
    """Return the orientation w x y z of a ground plane with the given slope and heading.

    The orientation is the shortest rotation from the horizontal plane to the slope.

    Args:
        slope_deg: Steepness [deg].
        heading_deg: Direction of steepest ascent, from world x towards world y [deg].
    """
    slope, heading = math.radians(slope_deg), math.radians(heading_deg)
    axis = np.array([math.sin(heading), -math.cos(heading), 0.0])
    return wxyz_from_rotation_vector(slope * axis)
