"""True contact transitions of a foot, how late an estimate follows them, and false ones."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from estimation.log_rows import Array

UNLOADED_BELOW, LOADED_ABOVE = (
    0.05,
    0.10,
)  # share of the weight that a load crosses when a contact closes, opens
FAST_LOAD_CHANGE, FAST_LOAD_TIME = (
    0.20,
    0.020,
)  # share of the weight per time [s] that makes a transition fast
MIN_PHASE_TIME = 0.020  # [s] a phase shorter than this need not be followed
MATCH_BEFORE, MATCH_AFTER = (
    0.020,
    0.300,
)  # [s] around a true transition within which one estimated is its own
IGNORED_START = 0.5  # [s] at a log's beginning in which nothing is called false


@dataclass(frozen=True)
class Transition:
    """A true transition of a foot.

    Attributes:
        row: The first on the other side of the threshold.
        closes: Whether the foot takes load.
        fast: Whether the load changes fast enough for the delay to be judged.
    """

    row: int
    closes: bool
    fast: bool


def true_transitions(share: Array, rate: float) -> list[Transition]:
    """Return the transitions of a foot's normal load (n,) as a share of the robot's weight.

    A load goes all the way: from above 10 % to below 5 % or back.
    """
    phases = _phases(share, max(1, round(MIN_PHASE_TIME * rate)))
    window = max(1, round(FAST_LOAD_TIME * rate))
    transitions = []
    for (_, end, _), (start, _, loaded) in pairwise(phases):
        load_between = share[end : start + 1]
        if loaded:
            row = end + 1 + int(np.flatnonzero(load_between[:-1] <= UNLOADED_BELOW)[-1])
        else:
            row = end + 1 + int(np.flatnonzero(load_between[:-1] >= LOADED_ABOVE)[-1])
        load_around = share[max(0, row - window) : row + window + 1]
        change = (load_around[window:] - load_around[:-window]) * (1.0 if loaded else -1.0)
        fast = bool(len(change) and change.max() >= FAST_LOAD_CHANGE)
        transitions.append(Transition(row, loaded, fast))
    return transitions


def _phases(share: Array, dwell: int) -> list[tuple[int, int, bool]]:
    """Return (first, last, loaded) of the phases surely loaded or surely not, none short."""
    kind = np.where(share > LOADED_ABOVE, 1, np.where(share < UNLOADED_BELOW, 0, -1))
    rows = np.flatnonzero(kind >= 0)
    phases: list[tuple[int, int, bool]] = []
    if len(rows) == 0:
        return phases
    breaks = np.flatnonzero(np.diff(kind[rows])) + 1
    for part in np.split(rows, breaks):
        phases.append((int(part[0]), int(part[-1]), bool(kind[part[0]])))
    while len(phases) > 1:
        lengths = [last - first + 1 for first, last, _ in phases]
        k = int(np.argmin(lengths))
        if lengths[k] >= dwell:
            break
        del phases[k]
        if 0 < k < len(phases) and phases[k - 1][2] == phases[k][2]:
            phases[k - 1 : k + 1] = [(phases[k - 1][0], phases[k][1], phases[k][2])]
    return phases


@dataclass
class TransitionScore:
    """How an estimate followed the transitions of one or more feet.

    Attributes:
        delays: [s] of those that are fast; infinite if missed, NaN if there was nothing to follow.
        false: Estimated transitions that belong to no true one.
        calibration: (m, 2) probability and truth in the neighbourhood of slow transitions.
    """

    delays: list[float]
    false: int
    calibration: Array

    def __add__(self, other: TransitionScore) -> TransitionScore:
        """Take two scores together."""
        both = np.concatenate([self.calibration, other.calibration])
        return TransitionScore(self.delays + other.delays, self.false + other.false, both)


def score_transitions(share: Array, probability: Array, rate: float) -> TransitionScore:
    """Score a foot's probability of contact (n,) against its load (n,), a share of the weight."""
    truth = true_transitions(share, rate)
    estimated = probability > 0.5
    changes = np.flatnonzero(np.diff(estimated)) + 1
    early, late = round(MATCH_BEFORE * rate), round(MATCH_AFTER * rate)
    matched = np.zeros(len(changes), bool)
    delays = []
    for k, transition in enumerate(truth):
        # The next is the other way round, so changes up to it are this one's.
        end = truth[k + 1].row if k + 1 < len(truth) else len(share)
        start = transition.row - early
        end = max(start + 1, min(end, transition.row + late))
        in_window = (changes >= start) & (changes < end)
        right = np.flatnonzero(in_window & (estimated[changes] == transition.closes))
        if len(right):
            matched[right[0]] = True
            delay = (changes[right[0]] - transition.row) / rate
        else:
            # It may be there already, because it never left or came too early: nothing to follow.
            delay = np.nan if estimated[max(0, start)] == transition.closes else np.inf
        if transition.fast:
            delays.append(float(np.maximum(delay, 0.0)))
    ambiguous = _near_partial_load(share, 2 * early) | _near_slow_transitions(
        len(share), truth, late
    )
    after_start = changes >= round(IGNORED_START * rate)
    short_contact = _load_crossed_threshold(share, changes, estimated[changes], early)
    false = int(np.sum(~matched & ~ambiguous[changes] & ~short_contact & after_start))
    return TransitionScore(delays, false, _calibration(share, probability, truth, late))


def _load_crossed_threshold(share: Array, changes: Array, closes: Array, reach: int) -> Array:
    """Return which changes follow a load that was there, if too shortly to be a transition."""
    windows = [share[max(0, row - reach) : row + 1] for row in changes]
    pairs = zip(windows, closes, strict=True)
    return np.array(
        [w.max() > UNLOADED_BELOW if up else w.min() < LOADED_ABOVE for w, up in pairs], bool
    )


def _near_partial_load(share: Array, reach: int) -> Array:
    """Return rows (n,) at most `reach` after a load that is neither none nor surely one."""
    between = (share >= 0.2 * UNLOADED_BELOW) & (share <= 1.5 * LOADED_ABOVE)
    spread = np.convolve(between, np.ones(reach), mode="full")[: len(share)]
    return np.asarray(spread > 0.0)


def _near_slow_transitions(size: int, truth: list[Transition], reach: int) -> Array:
    """Return rows (n,) near slow transitions, where only the calibration counts."""
    near = np.zeros(size, bool)
    for transition in truth:
        if not transition.fast:
            near[max(0, transition.row - reach) : transition.row + reach] = True
    return near


def _calibration(share: Array, probability: Array, truth: list[Transition], reach: int) -> Array:
    rows = _near_slow_transitions(len(share), truth, reach) & (
        (share < UNLOADED_BELOW) | (share > LOADED_ABOVE)
    )
    return np.stack([probability[rows], share[rows] > LOADED_ABOVE], axis=1)
