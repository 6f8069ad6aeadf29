"""Contact transitions and slip events of an estimate."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from surefoot.estimate.estimate_result import Estimate
from surefoot.geometry.batch_rotations import Array
from surefoot.messages.low_state_layout import LEGS

# Value of contact confidence or slip above which a foot counts as in contact or slipping. Chosen:
# more likely than not.
THRESHOLD = 0.5
# [s] Shortest swing between two stances of a gait. Chosen: a foot bounces for up to 40 ms after
# touch-down, and the swings of trotting robots last longer than 100 ms.
MIN_SWING_TIME = 0.08


@dataclass(frozen=True)
class Transition:
    """Touch-down or lift-off of a foot.

    Attributes:
        time: Time of the first row after the change [s].
        leg: 0 .. 3, in the order FR FL RR RL.
        begins: True for a touch-down, false for a lift-off.
    """

    time: float
    leg: int
    begins: bool


def transitions(time: Array, on: Array) -> list[Transition]:
    """Return the rows in which `on` (n, 4) crosses THRESHOLD, in order of `time` (n,) [s].

    Rows with NaN are skipped.
    """
    known = np.isfinite(on).all(axis=1)
    time, states = time[known], on[known] > THRESHOLD
    rows, legs = np.nonzero(states[1:] != states[:-1])
    return [
        Transition(float(time[row + 1]), int(leg), bool(states[row + 1, leg]))
        for row, leg in zip(rows, legs, strict=True)
    ]


def stance_rows(contact: npt.NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return first row and row after the last of each stance, from the contact (n,) of a foot.

    A stance that the ends of the log cut counts too.
    """
    edges = np.diff(np.concatenate([[False], contact, [False]]).astype(np.int8))
    pairs = zip(np.flatnonzero(edges > 0), np.flatnonzero(edges < 0), strict=True)
    return [(int(start), int(end)) for start, end in pairs]


def joined_stances(time: Array, contact: npt.NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return stance_rows() with stances joined that a swing shorter than MIN_SWING_TIME parts."""
    joined: list[tuple[int, int]] = []
    for start, end in stance_rows(contact):
        if joined and time[start] - time[joined[-1][1]] < MIN_SWING_TIME:
            joined[-1] = (joined[-1][0], end)
        else:
            joined.append((start, end))
    return joined


def row_durations(estimate: Estimate) -> Array:
    """Return the time from each row to the next (m,) [s]; the last row lasts one period."""
    return np.diff(estimate.time, append=estimate.time[-1] + estimate.log.period)


def slip_events(estimate: Estimate) -> list[dict[str, object]]:
    """Return time [s], foot and duration [s] of each slip: Estimate.slip is above THRESHOLD."""
    end = float(estimate.time[-1])
    events: list[dict[str, object]] = []
    start_times: dict[int, float] = {}
    # Put a row without slip first, so that a slip which is present in row 0 also counts.
    time = np.concatenate([estimate.time[:1], estimate.time])
    slip = np.vstack([np.zeros((1, 4)), estimate.slip])
    changes = transitions(time, slip)
    slip_ends = [Transition(end, leg, False) for leg in range(4)]
    for change in [*changes, *slip_ends]:
        if change.begins:
            start_times[change.leg] = change.time
        elif change.leg in start_times:
            start = start_times.pop(change.leg)
            foot, lasted = LEGS[change.leg], change.time - start
            events.append({"time": start, "foot": foot, "duration_s": lasted})
    return sorted(events, key=lambda event: float(str(event["time"])))
