"""Sweep over push levels: finds the largest push level up to which all pushes were passed."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

from surefoot._core import Error
from surefoot.assess.push_outcome import PushOutcome

# Protocol of docs/reference/scorecard.md, chosen so that a sweep takes 10 to 12 runs. START_LEVELS
# successive seeds together try all ten levels up to 100 %.
MIN_LEVEL = 10.0  # [% of the push limit] lowest level
MAX_LEVEL = 200.0  # [% of the push limit] highest level
COARSE_STEP = 20.0  # [% of the push limit] step between levels until the robot does not survive
START_LEVELS = 6  # successive seeds start at MIN_LEVEL, 2 MIN_LEVEL, .. START_LEVELS * MIN_LEVEL
FINE_STEPS = 5.0, 2.5  # [% of the push limit] steps of the two refinements, in their order
FINEST_STEP = FINE_STEPS[-1]


@dataclass
class Sweep:
    """Push levels of one direction and one seed.

    Attributes:
        outcomes: Outcome of each level that was tried, by level [% of the push limit].
    """

    outcomes: dict[float, PushOutcome] = field(default_factory=dict)

    def largest_passed(self, kind: str) -> float:
        """Return the largest level up to which all tried levels passed [% of the push limit].

        0: the lowest tried level did not pass, or no level was tried.

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
    """Return the first level of a sweep [% of the push limit].

    The sweeps of START_LEVELS successive seeds together try all multiples of MIN_LEVEL.

    Args:
        seed_index: Index of the seed in the scorecard, from 0.
    """
    return MIN_LEVEL * (1 + seed_index % START_LEVELS)


def percent_text(percent: float) -> str:
    """Return a level [%] as text; a "+" after MAX_LEVEL says that the true limit may be higher."""
    return f"{percent:.1f}" + ("+" if percent >= MAX_LEVEL else "")


def run_sweep(
    run: Callable[[float], PushOutcome],
    start_level: float = MIN_LEVEL,
    finest_step: float = FINEST_STEP,
) -> Sweep:
    """Try push levels in coarse steps until the robot does not survive, then in fine steps.

    Coarse levels rise in steps of COARSE_STEP until the robot does not survive, or to MAX_LEVEL.
    Then, for each criterion and each step of FINE_STEPS, the levels rise from the largest passed
    level towards the first failed level, until a level fails. The sweep does not bisect: a weak
    push that fails ends the sweep, even if a stronger push would pass.

    Args:
        run: Function that runs one level [% of the push limit] and returns its outcome.
        start_level: First level [% of the push limit].
        finest_step: Smallest step of FINE_STEPS to use [% of the push limit].

    Raises:
        Error: finest_step is not in FINE_STEPS.
    """
    if finest_step not in FINE_STEPS:
        raise Error(
            f"finest: got {finest_step:g} %, expected {' or '.join(f'{s:g}' for s in FINE_STEPS)}"
        )
    sweep = Sweep()
    for level in (*_levels(start_level, MAX_LEVEL - FINEST_STEP, COARSE_STEP), MAX_LEVEL):
        sweep.outcomes[level] = run(level)
        if not sweep.outcomes[level].survived:
            break
    for kind in ("survived", "in_place"):
        for step in (step for step in FINE_STEPS if step >= finest_step):
            _refine(sweep, run, kind, step)
    return sweep


def _refine(sweep: Sweep, run: Callable[[float], PushOutcome], kind: str, step: float) -> None:
    """Try levels between the largest passed level and the first failed level, until one fails."""
    last = sweep.largest_passed(kind)
    levels_above = [level for level in sweep.outcomes if level > last]
    for level in _levels(last + step, min(levels_above, default=last) - step, step):
        if level not in sweep.outcomes:
            sweep.outcomes[level] = run(level)
        if not getattr(sweep.outcomes[level], kind):
            break


def _levels(low: float, high: float, step: float) -> Iterator[float]:
    for k in range(1 + math.floor((high - low) / step)):
        yield low + k * step


def outcome_rows(sweep: Sweep) -> list[list[Any]]:
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
        for level, o in sorted(sweep.outcomes.items())
    ]


def rows_to_sweep(rows: list[list[Any]]) -> Sweep:
    """Return the sweep that outcome_rows() converted to `rows`."""
    return Sweep({row[0]: PushOutcome(*row[1:]) for row in rows})


def _rounded(value: float | None) -> float | None:
    return None if value is None else round(value, 3)
