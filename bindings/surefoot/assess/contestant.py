"""Who is assessed: a built-in controller, or any callable LowState -> LowCmd."""

from __future__ import annotations

import importlib
import inspect
import math
import os
import struct
import sys
from collections.abc import Callable
from contextlib import redirect_stdout
from dataclasses import dataclass, field
from functools import partial
from typing import Any

from surefoot._core import Error, LowCmd, LowState, Robot, StandController, StandOptions
from surefoot.gain_files import gains_of
from surefoot.low_state_layout import MOTORS

Act = Callable[[LowState], LowCmd]
Factory = Callable[..., Any]
REFERENCES = ("pd", "force_qp")
BUILT_IN = ("surefoot", *REFERENCES)
_UNPREDICTED = 0.0095  # [s] of delay: two periods and a latency of 5 ms are left as they are
_FARTHEST = 0.05  # [s] of StandOptions.delay
_FIELDS = ("q", "dq", "tau", "Kp", "Kd")
_NUMBERS = struct.Struct("<22x" + MOTORS * "x5f12x")  # of a LowCmd's twelve motors, and no more


class Broken(Exception):
    """A controller did not do what a controller does; the text says what."""


@dataclass(frozen=True)
class Contestant:
    """A controller that can be made anew, here or in another process.

    Attributes:
        name: Of BUILT_IN, or MODULE:CALLABLE, or what a callable is called.
        gains: Every gain of "surefoot" by name; empty for the robot's own.
        factory: Called with the surefoot.Robot, and with delay= if it has such a parameter; returns
            what is called with each LowState, or something with a method update() that is; None:
            found by the name.
    """

    name: str = "surefoot"
    gains: dict[str, float] = field(default_factory=dict)
    factory: Factory | None = None

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
        except (Exception, SystemExit) as problem:
            raise Broken(f"making it threw {_told(problem)}") from None
        act = getattr(made, "update", made)
        if not callable(act):
            raise Broken(f"making it gave {type(made).__name__}, expected something to call")
        return _checked(act)


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
    except (Exception, SystemExit) as problem:
        raise Error(f"controller '{name}': {_told(problem)}") from None
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


def _checked(act: Act) -> Act:
    def call(state: LowState) -> LowCmd:
        try:
            command = act(state)
        except (Exception, SystemExit) as problem:
            raise Broken(f"threw {_told(problem)}") from None
        if not isinstance(command, LowCmd):
            raise Broken(f"returned {_shape(command)}, expected a LowCmd")
        _check_finite(command)
        return command

    return call


def _check_finite(command: LowCmd) -> None:
    values = _NUMBERS.unpack_from(command.raw.data)
    # A sum of float32 in double is finite if and only if all of them are.
    if math.isfinite(sum(values)):
        return
    first = next(k for k, value in enumerate(values) if not math.isfinite(value))
    motor, name = first // len(_FIELDS), _FIELDS[first % len(_FIELDS)]
    raise Broken(f"returned {name} = {values[first]} for motor {motor}, expected finite numbers")


def _shape(value: Any) -> str:
    shape = getattr(value, "shape", None)
    return type(value).__name__ + (f" of shape {shape}" if shape is not None else "")


def _told(problem: BaseException) -> str:
    text = " ".join(str(problem).split())
    return f"{type(problem).__name__}: {text}" if text else type(problem).__name__
