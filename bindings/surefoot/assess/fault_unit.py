"""A cell of the matrix of faults as a unit of work."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any, ClassVar

from surefoot._core import Robot, Supervisor, SupervisorOptions
from surefoot.assess.contestant import Contestant
from surefoot.assess.ground import Source, describe
from surefoot.assess.unit import Beat
from surefoot.faults.run import attempt
from surefoot.faults.setting import Setup, set_up
from surefoot.gain_files import gains_of


@dataclass(frozen=True)
class FaultUnit:
    """A cell of the matrix of faults.

    Attributes:
        cell: Its id.
    """

    cell: str
    patience: ClassVar[float] = 20.0

    @property
    def key(self) -> str:
        """Its name in the store."""
        return f"fault | {self.cell}"

    def run(self, source: Source, contestant: Contestant, beat: Beat) -> dict[str, Any]:
        """Run it and return what came of it as plain JSON."""
        setup = _setup(source)
        if contestant.gains:
            setup = replace(setup, make_supervisor=_with_gains(contestant.gains))
        beat()
        found = attempt(setup, self.cell)
        return {name: found[name] for name in ("row", "verdict", "reason")}


def _with_gains(values: dict[str, float]) -> Callable[[Robot, SupervisorOptions], Supervisor]:
    gains = gains_of(values)
    return lambda robot, options: Supervisor(robot, gains, options)


@lru_cache(maxsize=1)
def _setup(source: Source) -> Setup:
    return set_up(describe(source), 0)
