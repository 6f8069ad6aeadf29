"""The sweep: which is the largest push below which every push that was tried is survived."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

from surefoot._core import Error
from surefoot.assess.push_outcome import PushOutcome

MIN_LEVEL = 10.0  # [%] of the robot's own limit
MAX_LEVEL = 200.0  # [%]
COARSE_STEP = 20.0  # [%]
START_LEVELS = 6  # seeds begin at LOWEST and up to so many times it, in turns
FINE_STEPS = 5.0, 2.5  # [%] one after the other
FINEST_STEP = FINE_STEPS[-1]


@dataclass
class Sweep:
    """Pushes of rising strength, one direction, one seed.

    Attributes:
        outcomes: Outcome of every level, percent of the robot's own limit.
    """

    outcomes: dict[float, PushOutcome] = field(default_factory=dict)

    def largest_passed(self, kind: str) -> float:
        """Return the largest level below which all that were tried passed, itself too; 0: none.

        Args:
            kind: "survived" or "in_place".
        """
        best = 0.0
        for level in sorted(self.outcomes):
            if not getattr(self.outcomes[level], kind):
                break
            best = level
        return best


def first_level(seed_index: int) -> float:
    """Return where a sweep begins [%]; TURNS of them try all multiples of LOWEST.

    Args:
        seed_index: Index of the seed among the card's, from 0.
    """
    return MIN_LEVEL * (1 + seed_index % START_LEVELS)


def percent_text(percent: float) -> str:
    """Return a limit as text; one that no sweep goes beyond may be more."""
    return f"{percent:.1f}" + ("+" if percent >= MAX_LEVEL else "")


def run_sweep(
    run: Callable[[float], PushOutcome],
    start_level: float = MIN_LEVEL,
    finest_step: float = FINEST_STEP,
) -> Sweep:
    """Push harder and harder: coarse until the robot does not survive, then fine where it tipped.

    Levels go up in steps of COARSE until one is not survived, to HIGHEST at most; then in each step
    of FINE from the last pass towards the first failure, upwards until one fails, for survival and
    for the criterion "in place" apart. It is no bisection: a weak push that fails where a strong one
    passes ends the count there.

    Args:
        run: Runs one level, in percent of the robot's own limit.
        start_level: Level to begin with.
        finest_step: Last of FINE that is gone in.

    Raises:
        Error: A step that is none of FINE.
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
    """Go up from the last pass, to below the first failure."""
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
    """Return a sweep as plain JSON: level, survived, strict, foot_mm, return_error_mm, return_error_deg."""
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
    """Return the sweep of outcome_rows()."""
    return Sweep({row[0]: PushOutcome(*row[1:]) for row in rows})


def _rounded(value: float | None) -> float | None:
    return None if value is None else round(value, 3)
