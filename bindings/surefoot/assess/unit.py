"""The units of work: what is run in one go, and is in the store when it is done."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from typing import Any

from surefoot.assess.card import Card
from surefoot.assess.condition import Condition
from surefoot.assess.contestant import Broken, Contestant
from surefoot.assess.ground import Source, plant_of
from surefoot.assess.push_run import Outcome, judge, run_length
from surefoot.assess.rollout import roll_out
from surefoot.assess.sweep import as_rows, sweep
from surefoot.sim import Push

Beat = Callable[[], None]
"""Called after every run: the contestant is alive."""


@dataclass(frozen=True)
class PushUnit:
    """Pushes of rising strength in one direction, one seed.

    Attributes:
        condition: Under which.
        degrees: Direction, from forward towards left [deg].
        duration: Of every push [s].
        lift: Of its line of action above the centre of mass [m].
        seed: Of sensors and motors.
        limit: The robot's own, which is 100 % [N.s].
    """

    condition: Condition
    degrees: float
    duration: float
    lift: float
    seed: int
    limit: float

    @property
    def key(self) -> str:
        """Its name in the store."""
        where = f"{self.degrees:g} deg, {self.duration:g} s, {self.lift:+g} m"
        return f"push | {self.condition.name} | {where} | {self.seed}"

    def run(self, source: Source, contestant: Contestant, beat: Beat) -> dict[str, Any]:
        """Run the sweep and return its rows as plain JSON."""

        def push(level: float) -> Outcome:
            begin = self.condition.quiet_s
            plant = plant_of(source, self.condition)
            impulse = level / 100.0 * self.limit
            plant.renew(self.seed, [Push(self.degrees, impulse, self.duration, begin, self.lift)])
            act = contestant.make(plant.robot)
            track = roll_out(plant, self.condition, act, run_length(begin, self.duration))
            beat()
            return judge(track, begin, self.duration)

        return {"rows": as_rows(sweep(push))}


Unit = PushUnit


def run_unit(
    unit: Unit, source: Source, contestant: Contestant, beat: Beat = lambda: None
) -> dict[str, Any]:
    """Run a unit; a contestant that breaks is a result as well.

    Returns:
        What the unit returns, or {"broken": why}.
    """
    try:
        return unit.run(source, contestant, beat)
    except Broken as problem:
        return {"broken": str(problem)}


def described(unit: Unit) -> dict[str, Any]:
    """Return a unit as plain data."""
    return asdict(unit)


def push_units(
    card: Card, limit_of: Callable[[Condition, float, float, float], float]
) -> Iterator[PushUnit]:
    """Yield the pushes of a card.

    Args:
        card: Which.
        limit_of: The robot's own limit for condition, degrees, duration [s], lift [m].
    """
    usual = card.conditions[0]
    shapes = [
        (usual, T, lift, card.degrees, card.seeds)
        for T in card.lengths_s
        for lift in card.heights_m
    ]
    shapes += [
        (condition, 0.1, 0.0, card.condition_degrees, card.condition_seeds)
        for condition in card.conditions[1:]
        if condition.pushes
    ]
    for condition, duration, lift, angles, seeds in shapes:
        for degrees in angles:
            limit = limit_of(condition, degrees, duration, lift)
            for seed in range(seeds):
                yield PushUnit(condition, degrees, duration, lift, seed, limit)
