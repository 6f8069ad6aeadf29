"""Frames that are lost on the link between robot and controller."""

from __future__ import annotations

import numpy as np

_STREAM = 17  # number of the random stream; the plant uses streams 0 .. 3


def lost_frames(percent: float, seed: int, ticks: int) -> np.ndarray:
    """Return a mask (2, ticks): True if the LowState (row 0) or LowCmd (row 1) of a tick is lost.

    In tick 0 no frame is lost.

    Args:
        percent: Share of frames lost in each direction [%].
        seed: Seed of the run.
        ticks: Number of ticks.
    """
    if percent == 0.0:
        return np.zeros((2, ticks), dtype=np.bool_)
    rng = np.random.default_rng([seed, _STREAM])
    lost = rng.uniform(size=(2, ticks)) < percent / 100.0
    lost[:, 0] = False
    return np.asarray(lost)
