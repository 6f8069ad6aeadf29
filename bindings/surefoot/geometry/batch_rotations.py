"""Conversions of n rotations at once; arrays have n rows."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]


def matrices_from_xyzw(quaternions: Array) -> Array:
    """Return the rotation matrices (n, 3, 3) of unit quaternions x y z w (n, 4)."""
    x, y, z, w = quaternions.T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), 2, 0)


def rpy_from_matrices(rotation: Array) -> Array:
    """Return roll, pitch, yaw (n, 3) [rad] of matrices R (n, 3, 3).

    R = Rz(yaw) Ry(pitch) Rx(roll).
    """
    R = rotation
    roll = np.arctan2(R[:, 2, 1], R[:, 2, 2])
    pitch = np.arcsin(np.clip(-R[:, 2, 0], -1.0, 1.0))
    yaw = np.arctan2(R[:, 1, 0], R[:, 0, 0])
    return np.stack([roll, pitch, yaw], axis=1)


def rotation_vectors(rotation: Array) -> Array:
    """Return the rotation vectors (n, 3) [rad] of matrices (n, 3, 3) with angles below pi."""
    R = rotation
    twice_sine = np.stack(
        [R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]], axis=1
    )
    size = np.linalg.norm(twice_sine, axis=1)
    angle = np.arctan2(size, np.trace(R, axis1=1, axis2=2) - 1.0)
    return np.asarray(twice_sine * (angle / np.maximum(size, 1e-12))[:, None])


def matrices_from_rotation_vectors(vectors: Array) -> Array:
    """Return the rotation matrices (n, 3, 3) of rotation vectors (n, 3) [rad]."""
    angle = np.linalg.norm(vectors, axis=1)[:, None, None]
    K = np.cross(vectors[:, None], -np.eye(3))
    half = 0.5 * np.sinc(angle / (2.0 * np.pi)) ** 2
    return np.asarray(np.eye(3) + np.sinc(angle / np.pi) * K + half * (K @ K))


def products(rotation: Array) -> Array:
    """Return the products R_0 ... R_k (n, 3, 3) of the first k + 1 rotations, for each k."""
    result, step = rotation.copy(), 1
    while step < len(result):
        result[step:] = result[:-step] @ result[step:]
        step *= 2
    return result


def rotations_about_z(angle: Array) -> Array:
    """Return the rotation matrices (n, 3, 3) by angles (n,) [rad] about z."""
    R = np.zeros((len(angle), 3, 3))
    R[:, 0, 0] = R[:, 1, 1] = np.cos(angle)
    R[:, 1, 0], R[:, 0, 1] = np.sin(angle), -np.sin(angle)
    R[:, 2, 2] = 1.0
    return R


def tilt_between(first: Array, second: Array) -> Array:
    """Return the angles (n,) [rad], up to pi / 2, between the verticals of two rotations.

    The rotations (n, 3, 3) are from base axes to world axes with z up; their yaw does not count.
    """
    sine = np.linalg.norm(np.cross(first[:, 2], second[:, 2]), axis=1)
    return np.asarray(np.arcsin(np.clip(sine, 0.0, 1.0)))
