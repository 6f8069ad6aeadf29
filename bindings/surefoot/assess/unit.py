"""The units of work: what is run in one go, and is in the store when it is done."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from functools import lru_cache
from typing import Any

from surefoot._core import Error
from surefoot.assess.condition import Condition
from surefoot.assess.contestant import Broken, Contestant
from surefoot.assess.ground import Source, describe, move_time, plant_of
from surefoot.assess.push_run import Outcome, judge, run_length
from surefoot.assess.rollout import roll_out
from surefoot.assess.stand_run import HOLD, judge_stand
from surefoot.assess.sweep import as_rows, sweep
from surefoot.faults.run import attempt
from surefoot.faults.setting import Setup, set_up
from surefoot.plain import plain
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


@dataclass(frozen=True)
class StandUnit:
    """A quiet stand, one seed.

    Attributes:
        condition: Under which.
        heading: Of slope or platform [deg].
        seed: Of sensors and motors.
    """

    condition: Condition
    heading: float
    seed: int

    @property
    def key(self) -> str:
        """Its name in the store."""
        return f"stand | {self.condition.name} | {self.heading:g} deg | {self.seed}"

    def run(self, source: Source, contestant: Contestant, beat: Beat) -> dict[str, Any]:
        """Run it and return what came of it as plain JSON."""
        condition = replace(self.condition, headings_deg=(self.heading,))
        plant = plant_of(source, condition)
        plant.renew(self.seed)
        act = contestant.make(plant.robot)
        length = condition.quiet_s + move_time(condition) + HOLD
        stood = judge_stand(roll_out(plant, condition, act, length), condition)
        beat()
        result: dict[str, Any] = plain({**asdict(stood), "passed": stood.passes(condition)})
        return result


@dataclass(frozen=True)
class FaultUnit:
    """A cell of the matrix of faults.

    Attributes:
        cell: Its id.
    """

    cell: str

    @property
    def key(self) -> str:
        """Its name in the store."""
        return f"fault | {self.cell}"

    def run(self, source: Source, contestant: Contestant, beat: Beat) -> dict[str, Any]:
        """Run it and return what came of it as plain JSON."""
        setup = _setup(source)
        beat()
        found = attempt(setup, self.cell)
        return {name: found[name] for name in ("row", "verdict", "reason")}


Unit = PushUnit | StandUnit | FaultUnit


def run_unit(
    unit: Unit, source: Source, contestant: Contestant, beat: Beat = lambda: None
) -> dict[str, Any]:
    """Run a unit; a contestant that breaks, or a plant that cannot be, is a result as well.

    Returns:
        What the unit returns, or {"broken": why}.
    """
    try:
        return unit.run(source, contestant, beat)
    except (Broken, Error) as problem:
        return {"broken": str(problem)}


@lru_cache(maxsize=1)
def _setup(source: Source) -> Setup:
    return set_up(describe(source), 0)
