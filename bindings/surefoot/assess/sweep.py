"""The sweep: which is the largest push below which every push that was tried is survived."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

from surefoot._core import Error
from surefoot.assess.push_run import Outcome

LOWEST = 10.0  # [%] of the robot's own limit
HIGHEST = 200.0  # [%]
COARSE = 20.0  # [%]
TURNS = 6  # seeds begin at LOWEST and up to so many times it, in turns
FINE = 5.0, 2.5  # [%] one after the other
FINEST = FINE[-1]


@dataclass
class Sweep:
    """Pushes of rising strength, one direction, one seed.

    Attributes:
        tried: Outcome of every level, percent of the robot's own limit.
    """

    tried: dict[float, Outcome] = field(default_factory=dict)

    def largest(self, kind: str) -> float:
        """Return the largest level below which all that were tried passed, itself too; 0: none.

        Args:
            kind: "survived" or "strict".
        """
        best = 0.0
        for level in sorted(self.tried):
            if not getattr(self.tried[level], kind):
                break
            best = level
        return best


def first_level(turn: int) -> float:
    """Return where a sweep begins [%]; TURNS of them try all multiples of LOWEST.

    Args:
        turn: Index of the seed among the card's, from 0.
    """
    return LOWEST * (1 + turn % TURNS)


def told(percent: float) -> str:
    """Return a limit as text; one that no sweep goes beyond may be more."""
    return f"{percent:.1f}" + ("+" if percent >= HIGHEST else "")


def sweep(run: Callable[[float], Outcome], first: float = LOWEST, finest: float = FINEST) -> Sweep:
    """Push harder and harder: coarse until the robot does not survive, then fine where it tipped.

    Levels go up in steps of COARSE until one is not survived, to HIGHEST at most; then in each step
    of FINE from the last pass towards the first failure, upwards until one fails, for survival and
    for the strict criterion apart. It is no bisection: a weak push that fails where a strong one
    passes ends the count there.

    Args:
        run: Runs one level, in percent of the robot's own limit.
        first: Level to begin with.
        finest: Last of FINE that is gone in.

    Raises:
        Error: A step that is none of FINE.
    """
    if finest not in FINE:
        raise Error(f"finest: got {finest:g} %, expected {' or '.join(f'{s:g}' for s in FINE)}")
    done = Sweep()
    for level in (*_steps(first, HIGHEST - FINEST, COARSE), HIGHEST):
        done.tried[level] = run(level)
        if not done.tried[level].survived:
            break
    for kind in ("survived", "strict"):
        for step in (step for step in FINE if step >= finest):
            _climb(done, run, kind, step)
    return done


def _climb(done: Sweep, run: Callable[[float], Outcome], kind: str, step: float) -> None:
    """Go up from the last pass, to below the first failure."""
    last = done.largest(kind)
    above = [level for level in done.tried if level > last]
    for level in _steps(last + step, min(above, default=last) - step, step):
        if level not in done.tried:
            done.tried[level] = run(level)
        if not getattr(done.tried[level], kind):
            break


def _steps(low: float, high: float, step: float) -> Iterator[float]:
    for k in range(1 + math.floor((high - low) / step)):
        yield low + k * step


def as_rows(done: Sweep) -> list[list[Any]]:
    """Return a sweep as plain JSON: level, survived, strict, foot_mm, back_mm, back_deg."""
    return [
        [level, o.survived, o.strict, _short(o.foot_mm), _short(o.back_mm), _short(o.back_deg)]
        for level, o in sorted(done.tried.items())
    ]


def from_rows(rows: list[list[Any]]) -> Sweep:
    """Return the sweep of as_rows()."""
    return Sweep({row[0]: Outcome(*row[1:]) for row in rows})


def _short(value: float | None) -> float | None:
    return None if value is None else round(value, 3)
