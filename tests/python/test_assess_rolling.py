# SPDX-License-Identifier: BSD-3-Clause
"""Rolling of a ball foot is no displacement; sliding, lifting and motion in the air are."""

from __future__ import annotations

import numpy as np
from surefoot.assess.motion_without_rolling import remove_rolling

RADIUS, UP, N = 0.03, np.array([0.0, 0.0, 1.0]), 400


def quaternions(axis: np.ndarray, angles: np.ndarray) -> np.ndarray:
    return np.concatenate([np.cos(angles / 2)[:, None], np.sin(angles / 2)[:, None] * axis], axis=1)


def rolling(
    angle: float, bearing: bool = True, normal: np.ndarray = UP
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return centres, attitudes and loaded flags of a foot that rolls about y by an angle."""
    axis, angles = np.array([0.0, 1.0, 0.0]), np.linspace(0.0, angle, N)
    centre = RADIUS * angles[:, None] * np.cross(axis, normal)
    turns = quaternions(axis, angles)
    return centre[:, None], turns[:, None], np.full((N, 1), bearing)


def test_rolling_without_slip_is_no_displacement() -> None:
    for angle in (-0.4, 0.4, 2.0):
        feet, turns, bearing = rolling(angle)
        # q and -q are the same attitude.
        turns[N // 2 :] *= -1.0
        left = remove_rolling(feet, turns, bearing, RADIUS, UP)
        assert np.abs(feet).max() > 0.01
        assert np.abs(left).max() < 1e-6


def test_rolling_on_a_slope_is_no_displacement() -> None:
    normal = np.array([np.sin(0.3), 0.0, np.cos(0.3)])
    feet, turns, bearing = rolling(0.5, normal=normal)
    assert np.abs(remove_rolling(feet, turns, bearing, RADIUS, normal)).max() < 1e-6


def test_sliding_and_lifting_are_displacement() -> None:
    feet, turns, bearing = rolling(0.4)
    slide = np.linspace(0.0, 1.0, N)[:, None, None] * np.array([0.004, -0.02, 0.01])
    left = remove_rolling(feet + slide, turns, bearing, RADIUS, UP)
    np.testing.assert_allclose(left, slide, atol=1e-6)


def test_rolling_is_not_subtracted_in_the_air() -> None:
    feet, turns, bearing = rolling(0.4, bearing=False)
    np.testing.assert_allclose(remove_rolling(feet, turns, bearing, RADIUS, UP), feet)
