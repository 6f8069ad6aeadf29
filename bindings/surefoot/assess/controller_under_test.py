"""Controller under test: a built-in controller, or any callable LowState -> LowCmd."""

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

from surefoot._core import (
    ControllerOptions,
    Error,
    Robot,
    StandController,
    WalkController,
    WalkOptions,
)
from surefoot.assess.checked_controller import (
    ControlFunction,
    ControllerFailure,
    WalkingControl,
    checked_controller,
    exception_text,
)
from surefoot.assess.time_limit import TimeLimitExceeded
from surefoot.robot.gain_files import gains_from_values

ControllerFactory = Callable[..., Any]
REFERENCE_CONTROLLERS = ("pd", "force_qp")
WALKING_REFERENCES = ("raibert",)
# [s] For delays up to this value "surefoot" does not predict, because prediction amplifies noise.
# Derived: two control periods (4 ms), a latency of 5 ms, and 0.5 ms of rounding.
_MIN_PREDICTED_DELAY = 0.0095
_MAX_PREDICTED_DELAY = 0.05  # [s] upper limit of ControllerOptions.delay


@dataclass(frozen=True)
class ControllerUnderTest:
    """A controller that can be constructed again in any process.

    Attributes:
        name: One of `built_in`, or MODULE:CALLABLE. If `factory` is set: any name that is not built
            in.
        gains: All gains by name, only for "surefoot"; empty: the robot's own gains.
        factory: Function that constructs the controller. It receives the surefoot.Robot and, if it
            has a parameter `delay`, also the delay of the loop [s]. It returns a callable LowState
            -> LowCmd, or an object whose method update() is such a callable. None: `name` selects
            the factory.
        walks: Whether the controller walks. It must then be an object that also has a method
            set_velocity(WalkVelocity).
    """

    name: str = "surefoot"
    gains: dict[str, float] = field(default_factory=dict)
    factory: ControllerFactory | None = None
    walks: bool = False

    @property
    def built_in(self) -> tuple[str, ...]:
        """Names of the built-in controllers that stand, or that walk."""
        return ("surefoot", *(WALKING_REFERENCES if self.walks else REFERENCE_CONTROLLERS))

    def __post_init__(self) -> None:
        if not isinstance(self.name, str):
            raise Error(f"controller: got {self.name!r}, expected a name")
        if self.factory is not None and self.name in self.built_in:
            raise Error(
                f"controller: got a factory called '{self.name}', expected another name: "
                f"{', '.join(self.built_in)} are built in"
            )
        if self.gains:
            if self.name != "surefoot":
                raise Error(
                    f"controller '{self.name}': got gains, expected none: only surefoot has gains"
                )
            gains_from_values(self.gains)

    def make(self, robot: Robot, delay: float) -> ControlFunction:
        """Construct a controller for one run.

        Args:
            robot: Model of the robot.
            delay: Delay from a measurement until the resulting command acts [s].

        Returns:
            The controller, with the checks of checked_controller().

        Raises:
            ControllerFailure: The factory raised an exception, or did not return a controller.
        """
        controller = self._construct(robot, delay)
        control = getattr(controller, "update", controller)
        # A dict has a method update(), but this method is not a controller.
        if isinstance(controller, dict) or not callable(control):
            raise ControllerFailure(
                f"the factory returned {type(controller).__name__}, expected a callable"
            )
        return checked_controller(control)

    def make_walking(self, robot: Robot, delay: float) -> WalkingControl:
        """Construct a controller that walks for one run; arguments and errors are as in make()."""
        controller = self._construct(robot, delay)
        for name in ("update", "set_velocity"):
            if not callable(getattr(controller, name, None)):
                raise ControllerFailure(
                    f"the factory returned {type(controller).__name__} without {name}(), expected "
                    "an object with set_velocity(WalkVelocity) and update(LowState)"
                )
        return WalkingControl(controller)

    def _construct(self, robot: Robot, delay: float) -> Any:
        factory = self.factory or find_factory(self)
        try:
            return factory(robot, delay=delay) if _takes_delay(factory) else factory(robot)
        # BaseException: SystemExit and asyncio.CancelledError do not derive from Exception.
        except BaseException as problem:
            raise ControllerFailure(f"the factory threw {exception_text(problem)}") from None


def find_factory(controller_under_test: ControllerUnderTest) -> ControllerFactory:
    """Return the factory of a controller under test.

    Raises:
        Error: The module or callable does not exist, or cannot be imported.
    """
    name = controller_under_test.name
    if name == "surefoot":
        make = make_walk_controller if controller_under_test.walks else make_stand_controller
        return partial(make, gains=controller_under_test.gains)
    if name in controller_under_test.built_in:
        from surefoot.assess.references import FACTORIES

        return FACTORIES[name]
    module, separator, path = name.partition(":")
    if not (module and separator and path):
        raise Error(
            f"controller: got '{name}', expected {', '.join(controller_under_test.built_in)} "
            "or module:callable"
        )
    if os.getcwd() not in sys.path:  # `python -m` adds the working directory too
        sys.path.insert(0, os.getcwd())
    try:
        with redirect_stdout(sys.stderr):
            target: Any = importlib.import_module(module)
        for part in path.split("."):
            target = getattr(target, part)
    except (TimeLimitExceeded, KeyboardInterrupt):  # these are not errors of the controller
        raise
    except BaseException as problem:
        raise Error(f"controller '{name}': {exception_text(problem)}") from None
    if not callable(target):
        raise Error(f"controller '{name}': got {type(target).__name__}, expected a callable")
    factory: ControllerFactory = target
    return factory


def make_stand_controller(robot: Robot, delay: float, gains: dict[str, float]) -> StandController:
    """Construct the "surefoot" controller for one run.

    Args:
        robot: Model of the robot.
        delay: Delay from a measurement until the resulting command acts [s].
        gains: All gains by name; empty: the robot's own gains.
    """
    # Over a few ticks, the amplified sensor noise of a prediction costs more than the delay.
    options = ControllerOptions(
        delay=min(delay, _MAX_PREDICTED_DELAY) if delay > _MIN_PREDICTED_DELAY else 0.0
    )
    return StandController(robot, gains_from_values(gains) if gains else None, options)


def make_walk_controller(robot: Robot, delay: float, gains: dict[str, float]) -> WalkController:
    """Construct the "surefoot" controller that walks; arguments as in make_stand_controller().

    While it steps, it predicts over two periods in any case.
    """
    options = ControllerOptions(
        delay=min(delay, _MAX_PREDICTED_DELAY) if delay > _MIN_PREDICTED_DELAY else 0.0
    )
    own = gains_from_values(gains) if gains else None
    return WalkController(robot, own, WalkOptions(options))


def _takes_delay(factory: ControllerFactory) -> bool:
    try:
        return "delay" in inspect.signature(factory).parameters
    except (TypeError, ValueError):  # some callables of extension modules have no signature
        return False
