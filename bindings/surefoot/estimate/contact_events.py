"""Contact transitions and slip events of an estimate."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from surefoot.estimate.estimate_result import Estimate
from surefoot.geometry.batch_rotations import Array
from surefoot.messages.low_state_layout import LEGS

# Value of contact confidence or slip above which a foot counts as in contact or slipping. Chosen:
# more likely than not.
THRESHOLD = 0.5


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
