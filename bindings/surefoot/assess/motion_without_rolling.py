"""Rolling of ball feet: the part of a foot centre's motion that rolling without slip causes."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from surefoot.geometry.rotations import Array


def remove_rolling(
    feet: Array, attitudes: Array, loaded: npt.NDArray[np.bool_], radius: float, normal: Array
) -> Array:
    """Subtract rolling from the motion of foot centres, so that only slides and lifts remain.

    When a ball rotates on the ground by a small vector phi without slip, its centre moves by
    radius phi x normal. When the body sways, the legs rotate the feet by about 0.2 rad. This moves
    the foot centres by millimetres, although no foot slips. A foot in the air does not roll.

    Args:
        feet: (n, feet, 3) foot centres in the world frame [m].
        attitudes: (n, feet, 4) orientations of the foot bodies, quaternions w x y z.
        loaded: (n, feet) True if the foot is loaded.
        radius: Radius of the feet [m].
        normal: (3,) unit vector of the ground normal in the world frame, upwards.

    Returns:
        (n, feet, 3) foot positions without rolling in the world frame [m]; row 0 equals `feet`.
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
