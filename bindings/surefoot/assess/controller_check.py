"""What a controller has to return, and what it is called when it does not."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable
from typing import Any

from surefoot._core import LowCmd, LowState
from surefoot.messages.low_state_layout import MOTOR_COUNT

ControlFunction = Callable[[LowState], LowCmd]
_MOTOR_FIELDS = ("q", "dq", "tau", "Kp", "Kd")
_MOTOR_VALUES = struct.Struct(
    "<22x" + MOTOR_COUNT * "x5f12x"
)  # of a LowCmd's twelve motors, and no more


class ControllerFailure(Exception):
    """A controller did not do what a controller does; the text says what."""


def checked_controller(act: ControlFunction) -> ControlFunction:
    """Return a controller that raises Broken where this one throws or returns no finite LowCmd."""

    def call(state: LowState) -> LowCmd:
        try:
            command = act(state)
        # SystemExit and asyncio's CancelledError are no Exceptions.
        except BaseException as problem:
            raise ControllerFailure(f"threw {exception_text(problem)}") from None
        if not isinstance(command, LowCmd):
            raise ControllerFailure(f"returned {_type_and_shape(command)}, expected a LowCmd")
        _check_finite(command)
        return command

    return call


def _check_finite(command: LowCmd) -> None:
    values = _MOTOR_VALUES.unpack_from(command.raw.data)
    # A sum of float32 in double is finite if and only if all of them are.
    if math.isfinite(sum(values)):
        return
    bad_index = next(k for k, value in enumerate(values) if not math.isfinite(value))
    motor, name = bad_index // len(_MOTOR_FIELDS), _MOTOR_FIELDS[bad_index % len(_MOTOR_FIELDS)]
    raise ControllerFailure(
        f"returned {name} = {values[bad_index]} for motor {motor}, expected finite numbers"
    )


def _type_and_shape(value: Any) -> str:
    shape = getattr(value, "shape", None)
    return type(value).__name__ + (f" of shape {shape}" if shape is not None else "")


def exception_text(problem: BaseException) -> str:
    """Return an exception in a line."""
    text = " ".join(str(problem).split())
    return f"{type(problem).__name__}: {text}" if text else type(problem).__name__
