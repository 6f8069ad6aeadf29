"""Check of a controller's commands, and the exception for a controller that fails."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable
from typing import Any

from surefoot._core import LowCmd, LowState, WalkVelocity
from surefoot.messages.low_state_layout import MOTOR_COUNT

ControlFunction = Callable[[LowState], LowCmd]
_MOTOR_FIELDS = ("q", "dq", "tau", "Kp", "Kd")
# This layout skips the header of a LowCmd and reads q, dq, tau, Kp, Kd of its twelve motors.
_MOTOR_VALUES = struct.Struct("<22x" + MOTOR_COUNT * "x5f12x")


class ControllerFailure(Exception):
    """A controller raised an exception, or did not return a LowCmd with finite values.

    The text of the exception has the reason.
    """


def checked_controller(control: ControlFunction) -> ControlFunction:
    """Wrap a controller: turn its exceptions and its invalid commands into ControllerFailure."""

    def call(state: LowState) -> LowCmd:
        try:
            command = control(state)
        # BaseException: SystemExit and asyncio.CancelledError do not derive from Exception.
        except BaseException as problem:
            raise ControllerFailure(f"threw {exception_text(problem)}") from None
        if not isinstance(command, LowCmd):
            raise ControllerFailure(f"returned {_type_and_shape(command)}, expected a LowCmd")
        _check_finite(command)
        return command

    return call


class WalkingControl:
    """A controller that walks, with the checks of checked_controller().

    Args:
        controller: Object with the methods set_velocity(WalkVelocity) and update(LowState).
    """

    def __init__(self, controller: Any) -> None:
        self._set_velocity = controller.set_velocity
        self._update = checked_controller(controller.update)

    def update(self, state: LowState, velocity: WalkVelocity) -> LowCmd:
        """Command a velocity, and return the command of the tick; raise ControllerFailure."""
        try:
            self._set_velocity(velocity)
        # BaseException: SystemExit and asyncio.CancelledError do not derive from Exception.
        except BaseException as problem:
            raise ControllerFailure(f"set_velocity threw {exception_text(problem)}") from None
        return self._update(state)


def _check_finite(command: LowCmd) -> None:
    values = _MOTOR_VALUES.unpack_from(command.raw.data)
    # The sum propagates NaN and infinity. A sum of float32 values cannot overflow in double
    # precision.
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
    """Return the type and the message of an exception as one line of text."""
    text = " ".join(str(problem).split())
    return f"{type(problem).__name__}: {text}" if text else type(problem).__name__
