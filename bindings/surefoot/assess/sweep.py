"""Sweep over push levels: find the largest push below which every tried push was passed."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

from surefoot._core import Error
from surefoot.assess.push_outcome import PushOutcome

# Protocol of docs/assess.md, chosen by hand: 10 to 12 runs a sweep. START_LEVELS seeds together try
# all ten levels to 100 %.
MIN_LEVEL = 10.0  # [%] of the push limit: lowest level
MAX_LEVEL = 200.0  # [%] highest level
COARSE_STEP = 20.0  # [%] first step
START_LEVELS = 6  # successive seeds start at MIN_LEVEL, 2 MIN_LEVEL, .. START_LEVELS * MIN_LEVEL
FINE_STEPS = 5.0, 2.5  # [%] steps of the refinements, in their order
FINEST_STEP = FINE_STEPS[-1]


@dataclass
class Sweep:
    """Push levels of one direction and one seed.

    Attributes:
        outcomes: Outcome by level in percent of the push limit.
    """

    outcomes: dict[float, PushOutcome] = field(default_factory=dict)

    def largest_passed(self, kind: str) -> float:
        """Return the largest level up to which all tried levels passed [%]; 0 if none did.

        Args:
            kind: Criterion: "survived" or "in_place".
        """
        best = 0.0
        for level in sorted(self.outcomes):
            if not getattr(self.outcomes[level], kind):
                break
            best = level
        return best


def first_level(seed_index: int) -> float:
    """Return the first level of a sweep [%].

    START_LEVELS sweeps with successive seeds together try all multiples of MIN_LEVEL.

    Args:
        seed_index: Index of the seed in the scorecard, from 0.
    """
    return MIN_LEVEL * (1 + seed_index % START_LEVELS)


def percent_text(percent: float) -> str:
    """Return a level as text; "+" marks MAX_LEVEL, where the true limit may be higher."""
    return f"{percent:.1f}" + ("+" if percent >= MAX_LEVEL else "")


def run_sweep(
    run: Callable[[float], PushOutcome],
    start_level: float = MIN_LEVEL,
    finest_step: float = FINEST_STEP,
) -> Sweep:
    """Try push levels in coarse steps until the robot does not survive, then in fine steps.

    Levels rise in steps of COARSE_STEP until one is not survived, at most to MAX_LEVEL. Then, for
    each criterion and each step of FINE_STEPS, levels rise from the last pass towards the first
    failure until one fails. This is no bisection: a weak push that fails ends the count, even if a
    stronger one passes.

    Args:
        run: Runs one level, in percent of the push limit.
        start_level: First level [%].
        finest_step: Last step of FINE_STEPS to use [%].

    Raises:
        Error: finest_step is not in FINE_STEPS.
    """
    if finest_step not in FINE_STEPS:
        raise Error(
            f"finest: got {finest_step:g} %, expected {' or '.join(f'{s:g}' for s in FINE_STEPS)}"
        )
    done = Sweep()
    for level in (*_levels(start_level, MAX_LEVEL - FINEST_STEP, COARSE_STEP), MAX_LEVEL):
        done.outcomes[level] = run(level)
        if not done.outcomes[level].survived:
            break
    for kind in ("survived", "in_place"):
        for step in (step for step in FINE_STEPS if step >= finest_step):
            _refine(done, run, kind, step)
    return done


def _refine(done: Sweep, run: Callable[[float], PushOutcome], kind: str, step: float) -> None:
    """Try levels from the last pass up to below the first failure."""
    last = done.largest_passed(kind)
    levels_above = [level for level in done.outcomes if level > last]
    for level in _levels(last + step, min(levels_above, default=last) - step, step):
        if level not in done.outcomes:
            done.outcomes[level] = run(level)
        if not getattr(done.outcomes[level], kind):
            break


def _levels(low: float, high: float, step: float) -> Iterator[float]:
    for k in range(1 + math.floor((high - low) / step)):
        yield low + k * step


def outcome_rows(done: Sweep) -> list[list[Any]]:
    """Return a sweep as JSON rows, the fields of PushOutcome after the level.

    Row: level, survived, in_place, foot_mm, return_error_mm, return_error_deg.
    """
    return [
        [
            level,
            o.survived,
            o.in_place,
            _rounded(o.foot_mm),
            _rounded(o.return_error_mm),
            _rounded(o.return_error_deg),
        ]
        for level, o in sorted(done.outcomes.items())
    ]


def rows_to_sweep(rows: list[list[Any]]) -> Sweep:
    """Return the sweep of the rows of outcome_rows()."""
    return Sweep({row[0]: PushOutcome(*row[1:]) for row in rows})


def _rounded(value: float | None) -> float | None:
    return None if value is None else round(value, 3)
