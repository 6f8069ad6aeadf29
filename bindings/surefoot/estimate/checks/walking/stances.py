"""Stances of the feet, from their heights relative to the base alone.

The heights need neither torques, foot forces nor the IMU, so a fault of these does not change the
stances. An order of the legs does not change them either.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from numpy.lib.stride_tricks import sliding_window_view

from surefoot.estimate.checks.walking.leg_paths import STEP, LegPaths

# [s] Half of the window in which the lowest and the highest position of a foot are searched.
# Chosen: the window contains a swing of every gait that is not very slow; in a slower gait a foot
# that stays low through the window stands.
HALF_WINDOW = 0.5
# Share of the range of heights below which a foot is low. Chosen: the body rises and sinks, and a
# slope lets a foot rise through its stance; the middle of a swing is far above.
LOW_SHARE = 0.3
# [leg length] Range of heights above which a foot steps. Chosen: half of a low swing of 2 cm of a
# robot of 0.25 m; more than the sole and the ground yield.
MIN_LIFT = 0.04
# Share of a low phase, and longest time [s], that is cut off at both ends. Chosen: soft soles let
# a foot move for up to 35 ms after touchdown and before lift-off (public log of a trotting Go1).
CUT_SHARE, MAX_CUT = 0.2, 0.04


@dataclass(frozen=True)
class Stances:
    """Stances on the grid of LegPaths.

    Attributes:
        middle: (n, 4) true in the middle part of the stance of a foot.
        low: (n, 4) true while a foot is low: its stance, and the ends of its swings.
        stepping: (n, 4) true if the foot swings within HALF_WINDOW before or after.
        steps: (4,) number of swings of each foot.
        stride: Median time from a lift-off to the next one of the same foot [s]; NaN without two
            swings of a foot.
    """

    middle: npt.NDArray[np.bool_]
    low: npt.NDArray[np.bool_]
    stepping: npt.NDArray[np.bool_]
    steps: npt.NDArray[np.int64]
    stride: float


def find_stances(paths: LegPaths) -> Stances:
    """Find the stances of all feet."""
    height = paths.height
    leg_length = float(-np.median(height))
    half = round(HALF_WINDOW / STEP)
    windows = sliding_window_view(np.pad(height, ((half, half), (0, 0)), "edge"), 2 * half + 1, 0)
    lowest, highest = windows.min(axis=2), windows.max(axis=2)
    lifted = highest - lowest > MIN_LIFT * leg_length
    low = ~lifted | (height < lowest + LOW_SHARE * (highest - lowest))
    middle = np.stack([_middle_parts(low[:, leg]) for leg in range(4)], axis=1)
    lift_offs = [np.flatnonzero(low[:-1, leg] & ~low[1:, leg]) for leg in range(4)]
    strides = np.concatenate([np.diff(times) for times in lift_offs]) * STEP
    stride = float(np.median(strides)) if len(strides) else float("nan")
    steps = np.array([len(times) for times in lift_offs])
    return Stances(middle & paths.valid[:, None], low, lifted, steps, stride)


def _middle_parts(low: npt.NDArray[np.bool_]) -> npt.NDArray[np.bool_]:
    """Cut off both ends of each low phase (n,), except at the ends of the log."""
    middle = np.zeros_like(low)
    for start, end in phases(low):
        cut = int(np.ceil(min(CUT_SHARE * (end - start), MAX_CUT / STEP)))
        first = start + cut if start > 0 else 0
        middle[first : end - cut if end < len(low) else end] = True
    return middle


def phases(active: npt.NDArray[np.bool_]) -> npt.NDArray[np.int64]:
    """Return first row and end row (k, 2) of each phase in which `active` (n,) is true."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], active.astype(int), [0]])))
    return np.asarray(edges.reshape(-1, 2), dtype=np.int64)
