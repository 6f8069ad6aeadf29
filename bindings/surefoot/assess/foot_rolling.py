"""Rolling of ball feet: the motion of a foot centre without slip."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from surefoot.geometry.rotations import Array


def remove_rolling(
    feet: Array, attitudes: Array, loaded: npt.NDArray[np.bool_], radius: float, normal: Array
) -> Array:
    """Return foot positions without the motion that rolling causes: only slides and lifts remain.

    A ball that rotates by a small vector phi on the ground without slip moves its centre by
    radius phi x normal. A leg that follows a swaying body rotates its foot by about 0.2 rad, which
    moves the centre by millimetres without slip. A foot in the air does not roll.

    Args:
        feet: (n, feet, 3) foot centres in the world frame [m].
        attitudes: (n, feet, 4) orientations of the foot bodies, quaternions w x y z.
        loaded: (n, feet) True where the foot is loaded.
        radius: Radius of the feet [m].
        normal: (3,) ground normal, unit vector, upwards.

    Returns:
        (n, feet, 3) positions that equal `feet` in row 0 [m].
    """
    before, after = attitudes[:-1], attitudes[1:]
    # For a small rotation, twice the vector part of after * conj(before) is the rotation vector.
    scalar_terms = before[..., :1] * after[..., 1:] - after[..., :1] * before[..., 1:]
    vector = scalar_terms - np.cross(after[..., 1:], before[..., 1:])
    sign = np.sign(np.sum(before * after, axis=-1, keepdims=True))
    rolled = radius * np.cross(2.0 * sign * vector, normal)
    rolled[~(loaded[:-1] & loaded[1:])] = 0.0
    unrolled = feet.copy()
    unrolled[1:] -= np.cumsum(rolled, axis=0)
    return unrolled
