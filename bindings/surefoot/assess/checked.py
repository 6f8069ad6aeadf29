"""What a controller has to return, and what it is called when it does not."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable
from typing import Any

from surefoot._core import LowCmd, LowState
from surefoot.low_state_layout import MOTORS

Act = Callable[[LowState], LowCmd]
_FIELDS = ("q", "dq", "tau", "Kp", "Kd")
_NUMBERS = struct.Struct("<22x" + MOTORS * "x5f12x")  # of a LowCmd's twelve motors, and no more


class Broken(Exception):
    """A controller did not do what a controller does; the text says what."""


def checked(act: Act) -> Act:
    """Return a controller that raises Broken where this one throws or returns no finite LowCmd."""

    def call(state: LowState) -> LowCmd:
        try:
            command = act(state)
        # SystemExit and asyncio's CancelledError are no Exceptions.
        except BaseException as problem:
            raise Broken(f"threw {told(problem)}") from None
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


def told(problem: BaseException) -> str:
    """Return an exception in a line."""
    text = " ".join(str(problem).split())
    return f"{type(problem).__name__}: {text}" if text else type(problem).__name__
