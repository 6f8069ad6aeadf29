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
from surefoot.assess.controller_check import (
    ControlFunction,
    ControllerFailure,
    checked_controller,
    exception_text,
)
from surefoot.assess.time_limit import TimeLimitExceeded
from surefoot.robot.gain_files import gains_from_values

ControllerFactory = Callable[..., Any]
REFERENCE_CONTROLLERS = ("pd", "force_qp")
BUILT_IN_CONTROLLERS = ("surefoot", *REFERENCE_CONTROLLERS)
_MIN_PREDICTED_DELAY = (
    0.0095  # [s] of delay: two periods and a latency of 5 ms are left as they are
)
_MAX_PREDICTED_DELAY = 0.05  # [s] of StandOptions.delay


@dataclass(frozen=True)
class ControllerUnderTest:
    """A controller that can be made anew, here or in another process.

    Attributes:
        name: Of BUILT_IN_CONTROLLERS, or MODULE:CALLABLE, or what the factory's controllers are called: a name
            that is not of BUILT_IN_CONTROLLERS.
        gains: Every gain by name, of "surefoot" alone; empty for the robot's own.
        factory: Called with the surefoot.Robot, and with delay= if it has such a parameter; returns
            what is called with each LowState, or something with a method update() that is; None:
            found by the name.
    """

    name: str = "surefoot"
    gains: dict[str, float] = field(default_factory=dict)
    factory: ControllerFactory | None = None

    def __post_init__(self) -> None:
        if not isinstance(self.name, str):
            raise Error(f"controller: got {self.name!r}, expected a name")
        if self.factory is not None and self.name in BUILT_IN_CONTROLLERS:
            raise Error(
                f"controller: got a factory called '{self.name}', expected another name: "
                f"{', '.join(BUILT_IN_CONTROLLERS)} are built in"
            )
        if self.gains:
            if self.name != "surefoot":
                raise Error(f"controller '{self.name}': got gains, which are for surefoot alone")
            gains_from_values(self.gains)

    def make(self, robot: Robot, delay: float) -> ControlFunction:
        """Make a controller for one run.

        Args:
            robot: That it is to control.
            delay: From a measurement to the action of the command made from it [s].

        Raises:
            ControllerFailure: It cannot be made, or what is made cannot be called.
        """
        factory = self.factory or find_factory(self)
        try:
            controller = factory(robot, delay=delay) if _takes_delay(factory) else factory(robot)
        # SystemExit and asyncio's CancelledError are no Exceptions.
        except BaseException as problem:
            raise ControllerFailure(f"making it threw {exception_text(problem)}") from None
        act = getattr(controller, "update", controller)
        if isinstance(controller, dict) or not callable(
            act
        ):  # a dict has an update() of another kind
            raise ControllerFailure(
                f"making it gave {type(controller).__name__}, expected something to call"
            )
        return checked_controller(act)


def find_factory(controller_under_test: ControllerUnderTest) -> ControllerFactory:
    """Return what makes a contestant's controllers.

    Raises:
        Error: No such module or callable, or it cannot be imported.
    """
    name = controller_under_test.name
    if name == "surefoot":
        return partial(make_stand_controller, gains=controller_under_test.gains)
    if name in BUILT_IN_CONTROLLERS:
        from surefoot.assess.references import FACTORIES

        return FACTORIES[name]
    module, separator, path = name.partition(":")
    if not (module and separator and path):
        raise Error(
            f"controller: got '{name}', expected {', '.join(BUILT_IN_CONTROLLERS)} or module:callable"
        )
    if os.getcwd() not in sys.path:  # as python -m has it
        sys.path.insert(0, os.getcwd())
    try:
        with redirect_stdout(sys.stderr):
            target: Any = importlib.import_module(module)
        for part in path.split("."):
            target = getattr(target, part)
    except (TimeLimitExceeded, KeyboardInterrupt):  # of who waits for it
        raise
    except BaseException as problem:
        raise Error(f"controller '{name}': {exception_text(problem)}") from None
    if not callable(target):
        raise Error(f"controller '{name}': got {type(target).__name__}, expected a callable")
    factory: ControllerFactory = target
    return factory


def make_stand_controller(robot: Robot, delay: float, gains: dict[str, float]) -> StandController:
    """Make "surefoot" for one run.

    Args:
        robot: That it is to control.
        delay: From a measurement to the action of the command made from it [s].
        gains: Every gain by name; empty for the robot's own.
    """
    # What a few ticks cost is less than what prediction adds of the sensors' noise.
    options = StandOptions(
        delay=min(delay, _MAX_PREDICTED_DELAY) if delay > _MIN_PREDICTED_DELAY else 0.0
    )
    return StandController(robot, gains_from_values(gains) if gains else None, options)


def _takes_delay(factory: ControllerFactory) -> bool:
    try:
        return "delay" in inspect.signature(factory).parameters
    except (TypeError, ValueError):  # not every callable of an extension has one
        return False
