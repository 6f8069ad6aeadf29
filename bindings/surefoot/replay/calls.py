"""Calls of a controller except update(), and conversion of their arguments to JSON and back."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from surefoot._core import BodyReference, Error, Gait, Mode, RequestStatus, WalkVelocity
from surefoot.robot.gain_files import gain_values, gains_from_values

_AXES = ("x", "y", "height", "roll", "pitch", "yaw")
_VELOCITY = ("vx", "vy", "yaw_rate")


@dataclass(frozen=True)
class _CallCodec:
    """Functions that convert a call's argument to JSON and back; None: the call has no argument.

    Attributes:
        to_json: Function that converts the argument to JSON.
        from_json: Function that converts JSON to the argument.
        is_attribute: True: the call sets an attribute of the controller.
    """

    to_json: Callable[[Any], Any] | None = None
    from_json: Callable[[Any], Any] | None = None
    is_attribute: bool = False


CALLS = {
    "arm": _CallCodec(),
    "request": _CallCodec(lambda mode: mode.name, lambda name: Mode[name]),
    "stop": _CallCodec(),
    "heartbeat": _CallCodec(),
    "reset": _CallCodec(),
    "set_body_reference": _CallCodec(
        lambda body: {axis: getattr(body, axis) for axis in _AXES},
        lambda axes: BodyReference(**axes),
    ),
    "set_velocity": _CallCodec(
        lambda velocity: {axis: getattr(velocity, axis) for axis in _VELOCITY},
        lambda axes: WalkVelocity(**axes),
    ),
    "gait": _CallCodec(lambda gait: gait.name, lambda name: Gait[name], is_attribute=True),
    "set_gains": _CallCodec(gain_values, gains_from_values),
}
"""Calls that a recording contains, by the name of the controller's method."""


def json_argument(name: str, *arguments: Any) -> Any:
    """Convert a call's argument to a JSON value.

    Args:
        name: Name of the call in CALLS.
        arguments: The argument of the call; none if the call has no argument.

    Returns:
        The JSON value; None if the call has no argument.

    Raises:
        Error: CALLS has no such call, or the arguments do not fit it.
    """
    codec = _codec(name)
    if len(arguments) != (codec.to_json is not None):
        expected = "none" if codec.to_json is None else "one"
        raise Error(f"call '{name}': got {len(arguments)} arguments, expected {expected}")
    try:
        return codec.to_json(*arguments) if codec.to_json is not None else None
    except (AttributeError, TypeError):
        raise Error(
            f"call '{name}': got {arguments[0]!r}, expected an argument of {name}()"
        ) from None


def repeat_call(controller: Any, name: str, argument: Any) -> str:
    """Repeat a recorded call and return answer_name() of its result.

    Args:
        controller: Controller to call.
        name: Name of the call in CALLS.
        argument: Argument as a JSON value; ignored if the call has no argument.

    Raises:
        Error: The controller has no such method, or the argument is invalid.
    """
    codec = _codec(name)
    try:
        arguments = () if codec.from_json is None else (codec.from_json(argument),)
    except (KeyError, TypeError, AttributeError) as problem:
        raise Error(f"log: call '{name}': got argument {argument!r} ({problem})") from None
    return answer_name(make_call(controller, name, *arguments))


def make_call(controller: Any, name: str, *arguments: Any) -> Any:
    """Call a method of the controller, or set its attribute; return the result of the method.

    Args:
        controller: Controller to call.
        name: Name of the call in CALLS.
        arguments: The argument of the call; none if the call has no argument.

    Raises:
        Error: The controller has no such method or attribute.
    """
    if not hasattr(type(controller), name):
        raise Error(f"call: got '{name}', expected a method of {type(controller).__name__}")
    if _codec(name).is_attribute:
        return setattr(controller, name, *arguments)
    return getattr(controller, name)(*arguments)


def answer_name(answer: Any) -> str:
    """Return the name of a RequestStatus; "" if the answer is of another type."""
    return answer.name if isinstance(answer, RequestStatus) else ""


def _codec(name: str) -> _CallCodec:
    if name not in CALLS:
        raise Error(f"call: got '{name}', expected one of {', '.join(CALLS)}")
    return CALLS[name]
