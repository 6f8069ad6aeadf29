"""Scores of contact estimates: delays against true transitions, and false transitions.

Loads are shares of the weight of the robot. At a fast true transition the delay of the estimate
counts. Near a slow true transition only the calibration of the contact confidence counts.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from estimation.log_rows import Array

# Load below which a foot is unloaded, and load above which a foot is loaded.
UNLOADED_BELOW, LOADED_ABOVE = 0.05, 0.10
# A transition is fast if the load changes by at least the first value within the second value [s].
FAST_LOAD_CHANGE, FAST_LOAD_TIME = 0.20, 0.020
MIN_PHASE_TIME = 0.020  # [s] phases shorter than this are ignored
# [s] Times before and after a true transition within which an estimated transition matches.
MATCH_BEFORE, MATCH_AFTER = 0.020, 0.300
IGNORED_START = 0.5  # [s] time at the start of a log in which no transition counts as false


@dataclass(frozen=True)
class Transition:
    """True transition of a foot.

    Attributes:
        row: First row with a load above UNLOADED_BELOW if the foot becomes loaded, or below
            LOADED_ABOVE if the foot becomes unloaded.
        becomes_loaded: True if the foot becomes loaded, false if it becomes unloaded.
        fast: True if the load changes fast enough for the delay to count.
    """

    row: int
    becomes_loaded: bool
    fast: bool


def true_transitions(share: Array, rate: float) -> list[Transition]:
    """Find the transitions of a foot from its normal load (n,), a share of the weight.

    In a transition the load goes from above 10 % to below 5 %, or back.
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
    """Return (first row, last row, loaded) of each clearly loaded or clearly unloaded phase.

    Phases of less than `dwell` rows are omitted.
    """
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
    """Score of an estimate over the transitions of one or more feet.

    Attributes:
        delays: Delay of each fast transition [s]. Infinite: the estimate missed it. NaN: the
            estimate already had the new state.
        false: Number of estimated transitions without a matching true transition.
        calibration: (m, 2) contact confidence and true contact near slow transitions.
    """

    delays: list[float]
    false: int
    calibration: Array

    def __add__(self, other: TransitionScore) -> TransitionScore:
        """Return the joint score of both scores."""
        both = np.concatenate([self.calibration, other.calibration])
        return TransitionScore(self.delays + other.delays, self.false + other.false, both)


def score_transitions(share: Array, confidence: Array, rate: float) -> TransitionScore:
    """Score the contact confidence (n,) of a foot against its load (n,), a share of the weight."""
    truth = true_transitions(share, rate)
    estimated = confidence > 0.5
    changes = np.flatnonzero(np.diff(estimated)) + 1
    early, late = round(MATCH_BEFORE * rate), round(MATCH_AFTER * rate)
    matched = np.zeros(len(changes), bool)
    delays = []
    for k, transition in enumerate(truth):
        # The next true transition has the opposite direction. So all estimated changes before the
        # next one belong to the present true transition.
        end = truth[k + 1].row if k + 1 < len(truth) else len(share)
        start = transition.row - early
        end = max(start + 1, min(end, transition.row + late))
        in_window = (changes >= start) & (changes < end)
        right = np.flatnonzero(in_window & (estimated[changes] == transition.becomes_loaded))
        if len(right):
            matched[right[0]] = True
            delay = (changes[right[0]] - transition.row) / rate
        else:
            # If the estimate already has the new state, there is no delay to measure.
            delay = np.nan if estimated[max(0, start)] == transition.becomes_loaded else np.inf
        if transition.fast:
            delays.append(float(np.maximum(delay, 0.0)))
    ambiguous = _near_partial_load(share, 2 * early) | _near_slow_transitions(
        len(share), truth, late
    )
    after_start = changes >= round(IGNORED_START * rate)
    short_contact = _load_crossed_threshold(share, changes, estimated[changes], early)
    false = int(np.sum(~matched & ~ambiguous[changes] & ~short_contact & after_start))
    return TransitionScore(delays, false, _calibration(share, confidence, truth, late))


def _load_crossed_threshold(
    share: Array, changes: Array, becomes_loaded: Array, reach: int
) -> Array:
    """Return for each change whether the load crossed the threshold, even briefly, just before."""
    windows = [share[max(0, row - reach) : row + 1] for row in changes]
    pairs = zip(windows, becomes_loaded, strict=True)
    return np.array(
        [w.max() > UNLOADED_BELOW if up else w.min() < LOADED_ABOVE for w, up in pairs], bool
    )


def _near_partial_load(share: Array, reach: int) -> Array:
    """Return the rows (n,) within `reach` after a load near the thresholds."""
    between = (share >= 0.2 * UNLOADED_BELOW) & (share <= 1.5 * LOADED_ABOVE)
    spread = np.convolve(between, np.ones(reach), mode="full")[: len(share)]
    return np.asarray(spread > 0.0)


def _near_slow_transitions(size: int, truth: list[Transition], reach: int) -> Array:
    """Return the rows (n,) near slow transitions, where only the calibration counts."""
    near = np.zeros(size, bool)
    for transition in truth:
        if not transition.fast:
            near[max(0, transition.row - reach) : transition.row + reach] = True
    return near


def _calibration(share: Array, confidence: Array, truth: list[Transition], reach: int) -> Array:
    rows = _near_slow_transitions(len(share), truth, reach) & (
        (share < UNLOADED_BELOW) | (share > LOADED_ABOVE)
    )
    return np.stack([confidence[rows], share[rows] > LOADED_ABOVE], axis=1)
