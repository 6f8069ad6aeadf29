"""Who is assessed: a built-in controller, or any callable LowState -> LowCmd."""

from __future__ import annotations

import importlib
import inspect
import os
import sys
from collections.abc import Callable
from contextlib import redirect_stdout
from dataclasses import dataclass, field
from functools import partial
from typing import Any

from surefoot._core import Error, Robot, StandController, StandOptions
from surefoot.assess.checked import Act, Broken, checked, told
from surefoot.assess.time_limit import Overdue
from surefoot.gain_files import gains_of

Factory = Callable[..., Any]
REFERENCES = ("pd", "force_qp")
BUILT_IN = ("surefoot", *REFERENCES)
_UNPREDICTED = 0.0095  # [s] of delay: two periods and a latency of 5 ms are left as they are
_FARTHEST = 0.05  # [s] of StandOptions.delay


@dataclass(frozen=True)
class Contestant:
    """A controller that can be made anew, here or in another process.

    Attributes:
        name: Of BUILT_IN, or MODULE:CALLABLE, or what the factory's controllers are called: a name
            that is not of BUILT_IN.
        gains: Every gain by name, of "surefoot" alone; empty for the robot's own.
        factory: Called with the surefoot.Robot, and with delay= if it has such a parameter; returns
            what is called with each LowState, or something with a method update() that is; None:
            found by the name.
    """

    name: str = "surefoot"
    gains: dict[str, float] = field(default_factory=dict)
    factory: Factory | None = None

    def __post_init__(self) -> None:
        if not isinstance(self.name, str):
            raise Error(f"controller: got {self.name!r}, expected a name")
        if self.factory is not None and self.name in BUILT_IN:
            raise Error(
                f"controller: got a factory called '{self.name}', expected another name: "
                f"{', '.join(BUILT_IN)} are built in"
            )
        if self.gains:
            if self.name != "surefoot":
                raise Error(f"controller '{self.name}': got gains, which are for surefoot alone")
            gains_of(self.gains)

    def make(self, robot: Robot, delay: float) -> Act:
        """Make a controller for one run.

        Args:
            robot: That it is to control.
            delay: From a measurement to the action of the command made from it [s].

        Raises:
            Broken: It cannot be made, or what is made cannot be called.
        """
        factory = self.factory or find_factory(self)
        try:
            made = factory(robot, delay=delay) if _asks_delay(factory) else factory(robot)
        # SystemExit and asyncio's CancelledError are no Exceptions.
        except BaseException as problem:
            raise Broken(f"making it threw {told(problem)}") from None
        act = getattr(made, "update", made)
        if isinstance(made, dict) or not callable(act):  # a dict has an update() of another kind
            raise Broken(f"making it gave {type(made).__name__}, expected something to call")
        return checked(act)


def find_factory(contestant: Contestant) -> Factory:
    """Return what makes a contestant's controllers.

    Raises:
        Error: No such module or callable, or it cannot be imported.
    """
    name = contestant.name
    if name == "surefoot":
        return partial(stand_controller, gains=contestant.gains)
    if name in BUILT_IN:
        from surefoot.assess.references import FACTORIES

        return FACTORIES[name]
    module, colon, path = name.partition(":")
    if not (module and colon and path):
        raise Error(f"controller: got '{name}', expected {', '.join(BUILT_IN)} or module:callable")
    if os.getcwd() not in sys.path:  # as python -m has it
        sys.path.insert(0, os.getcwd())
    try:
        with redirect_stdout(sys.stderr):
            found: Any = importlib.import_module(module)
        for part in path.split("."):
            found = getattr(found, part)
    except (Overdue, KeyboardInterrupt):  # of who waits for it
        raise
    except BaseException as problem:
        raise Error(f"controller '{name}': {told(problem)}") from None
    if not callable(found):
        raise Error(f"controller '{name}': got {type(found).__name__}, expected a callable")
    factory: Factory = found
    return factory


def stand_controller(robot: Robot, delay: float, gains: dict[str, float]) -> StandController:
    """Make "surefoot" for one run.

    Args:
        robot: That it is to control.
        delay: From a measurement to the action of the command made from it [s].
        gains: Every gain by name; empty for the robot's own.
    """
    # What a few ticks cost is less than what prediction adds of the sensors' noise.
    options = StandOptions(delay=min(delay, _FARTHEST) if delay > _UNPREDICTED else 0.0)
    return StandController(robot, gains_of(gains) if gains else None, options)


def _asks_delay(factory: Factory) -> bool:
    try:
        return "delay" in inspect.signature(factory).parameters
    except (TypeError, ValueError):  # not every callable of an extension has one
        return False
