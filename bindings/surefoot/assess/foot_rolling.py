"""What a ball foot does that stays where it is: it rolls."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from surefoot.geometry.rotations import Array


def remove_rolling(
    feet: Array, attitudes: Array, loaded: npt.NDArray[np.bool_], radius: float, normal: Array
) -> Array:
    """Return the way of foot centres less what they rolled: where feet slid or lifted to.

    A ball that turns by a small vector phi on the ground without slipping moves its centre by
    radius phi x normal. A leg that follows a swaying body turns its foot by a fifth of a radian,
    and so moves it by millimetres though nothing slips. In the air a foot rolls on nothing.

    Args:
        feet: (n, feet, 3) centres [m], world.
        attitudes: (n, feet, 4) attitudes of what they are part of, quaternions w x y z.
        loaded: (n, feet) does the ground bear any of it?
        radius: Of the feet [m].
        normal: (3,) of the ground, unit, upwards.
    """
    before, after = attitudes[:-1], attitudes[1:]
    # The vector part of after * conj(before), twice, is the turn of so short a time.
    scalar_terms = before[..., :1] * after[..., 1:] - after[..., :1] * before[..., 1:]
    vector = scalar_terms - np.cross(after[..., 1:], before[..., 1:])
    sign = np.sign(np.sum(before * after, axis=-1, keepdims=True))
    rolled = radius * np.cross(2.0 * sign * vector, normal)
    rolled[~(loaded[:-1] & loaded[1:])] = 0.0
    unrolled = feet.copy()
    unrolled[1:] -= np.cumsum(rolled, axis=0)
    return unrolled
