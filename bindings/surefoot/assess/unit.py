"""The units of work: what is run in one go, and is in the store when it is done."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from typing import Any, ClassVar, Protocol

from surefoot._core import Error
from surefoot.assess.checked import Broken
from surefoot.assess.condition import Condition
from surefoot.assess.contestant import Contestant
from surefoot.assess.ground import Source, delay_of, move_time, plant_of
from surefoot.assess.push_run import BROKEN, Outcome, judge, run_length
from surefoot.assess.rollout import Track, Watch, roll_out
from surefoot.assess.stand_run import HOLD, judge_stand
from surefoot.assess.sweep import FINEST, LOWEST, as_rows, sweep
from surefoot.plain import plain
from surefoot.sim import Push

Beat = Callable[[], None]
"""Called before the first run and after every run: the contestant is alive."""


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
        first: Level that the sweep begins with [%].
        finest: Step that its limit is told in [%].
    """

    condition: Condition
    degrees: float
    duration: float
    lift: float
    seed: int
    limit: float
    first: float = LOWEST
    finest: float = FINEST
    patience: ClassVar[float] = 1.0

    @property
    def key(self) -> str:
        """Its name in the store."""
        where = f"{self.degrees:g} deg, {self.duration:g} s, {self.lift:+g} m"
        return f"push | {self.condition.name} | {where} | {self.seed}"

    def run(self, source: Source, contestant: Contestant, beat: Beat) -> dict[str, Any]:
        """Run the sweep and return its rows as plain JSON.

        A controller that breaks under a push has not survived that one; the first reason is kept.
        """
        broken: dict[str, str] = {}

        def push(level: float) -> Outcome:
            try:
                track = self.play(source, contestant, level)
            except Broken as problem:
                broken.setdefault("broken", str(problem))
                return BROKEN
            finally:
                beat()
            return judge(track, self.condition.quiet_s, self.duration)

        plant_of(source, self.condition)
        beat()  # the deadline is for runs
        return {"rows": as_rows(sweep(push, self.first, self.finest)), **broken}

    def play(
        self, source: Source, contestant: Contestant, level: float, watch: Watch | None = None
    ) -> Track:
        """Run one level, in percent of the limit; raises Broken, Error."""
        begin, plant = self.condition.quiet_s, plant_of(source, self.condition)
        impulse = level / 100.0 * self.limit
        plant.renew(self.seed, [Push(self.degrees, impulse, self.duration, begin, self.lift)])
        act = contestant.make(plant.robot, delay_of(plant))
        length = run_length(begin, self.duration)
        return roll_out(plant, self.condition, act, length, watch)


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
    patience: ClassVar[float] = 1.0

    @property
    def key(self) -> str:
        """Its name in the store."""
        return f"stand | {self.condition.name} | {self.heading:g} deg | {self.seed}"

    def run(self, source: Source, contestant: Contestant, beat: Beat) -> dict[str, Any]:
        """Run it and return what came of it as plain JSON."""
        plant_of(source, self._turned)
        beat()  # the deadline is for runs
        stood = judge_stand(self.play(source, contestant), self.condition)
        result: dict[str, Any] = plain({**asdict(stood), "passed": stood.passes(self.condition)})
        return result

    def play(self, source: Source, contestant: Contestant, watch: Watch | None = None) -> Track:
        """Run it; raises Broken, Error."""
        condition = self._turned
        plant = plant_of(source, condition)
        plant.renew(self.seed)
        length = condition.quiet_s + move_time(condition) + HOLD
        act = contestant.make(plant.robot, delay_of(plant))
        return roll_out(plant, condition, act, length, watch)

    @property
    def _turned(self) -> Condition:
        return replace(self.condition, headings_deg=(self.heading,))


class Unit(Protocol):
    """What is run in one go.

    Attributes:
        patience: Times the deadline that it may take from beat to beat.
    """

    patience: ClassVar[float]

    @property
    def key(self) -> str:
        """Its name in the store."""

    def run(self, source: Source, contestant: Contestant, beat: Beat) -> dict[str, Any]:
        """Run it and return what came of it as plain JSON; raises Broken, Error."""


def run_unit(
    unit: Unit, source: Source, contestant: Contestant, beat: Beat = lambda: None
) -> dict[str, Any]:
    """Run a unit; a contestant that breaks, or a plant that cannot be, is a result as well.

    Returns:
        What the unit returns, or {"broken": why} alone.
    """
    try:
        return unit.run(source, contestant, beat)
    except (Broken, Error) as problem:
        return {"broken": str(problem)}
