"""What an assessment is asked to be."""

from __future__ import annotations

import pickle
from dataclasses import dataclass, field
from typing import Any

from surefoot._core import Error, Robot
from surefoot.assess.card import Card, standard_card
from surefoot.assess.contestant import Contestant, find_factory
from surefoot.assess.ground import Source, describe
from surefoot.assess.time_limit import time_limit
from surefoot.robots import build_robot, identity
from surefoot.sim.checks import number, whole

MOST_JOBS = 256
A_DAY = 86400.0  # [s]


@dataclass(frozen=True)
class AssessSettings:
    """Robot, contestant, card, processes, store.

    Attributes:
        robot: A name of surefoot.available_robots(), or the paths of a URDF and a TOML.
        contestant: Who is assessed.
        card: What is asked.
        jobs: Processes. Everything runs in processes of its own, so that none can stop the rest.
        deadline: For one run of a few seconds [s] of wall time; who takes longer never returns.
        store: File that results are kept in, and taken from; None keeps them in memory.
    """

    robot: Source = "go1"
    contestant: Contestant = field(default_factory=Contestant)
    card: Card = field(default_factory=lambda: standard_card("quick"))
    jobs: int = 1
    deadline: float = 60.0
    store: str | None = None

    def __post_init__(self) -> None:
        whole("jobs", self.jobs, 1, MOST_JOBS)
        number("deadline", self.deadline, 0.1, A_DAY)
        _is_a("contestant", self.contestant, Contestant)
        _is_a("card", self.card, Card)
        if self.contestant.factory is None:
            with time_limit(self.deadline, f"controller '{self.contestant.name}': its import"):
                find_factory(self.contestant)
        try:
            pickle.dumps(self.contestant)
        except (pickle.PicklingError, AttributeError, TypeError) as problem:
            raise Error(
                f"controller '{self.contestant.name}': cannot be handed to another process "
                f"({problem}); expected a function or class of a module"
            ) from None

    def build(self) -> Robot:
        """Return the robot; raises Error."""
        return build_robot(describe(self.robot))

    def described(self, robot: Robot) -> dict[str, Any]:
        """Return as plain data what makes two runs the same."""
        return {
            **identity(describe(self.robot), robot),
            "controller": self.contestant.name,
            "gains": self.contestant.gains,
            "card": self.card.described(),
        }


def _is_a(name: str, value: Any, kind: type) -> None:
    if not isinstance(value, kind):
        raise Error(f"{name}: got {value!r}, expected a {kind.__name__}")
