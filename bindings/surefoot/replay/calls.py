"""Calls of a controller besides update(): their arguments as JSON knows them, and back."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from surefoot._core import BodyReference, Error, Mode, RequestStatus
from surefoot.gain_files import gain_values, gains_of

_AXES = ("x", "y", "height", "roll", "pitch", "yaw")


@dataclass(frozen=True)
class _Kind:
    """How a call's argument becomes plain data, and what it was; None: it has none."""

    plain: Callable[[Any], Any] | None = None
    back: Callable[[Any], Any] | None = None


CALLS = {
    "arm": _Kind(),
    "request": _Kind(lambda mode: mode.name, lambda name: Mode[name]),
    "stop": _Kind(),
    "heartbeat": _Kind(),
    "reset": _Kind(),
    "set_body_reference": _Kind(
        lambda body: {axis: getattr(body, axis) for axis in _AXES},
        lambda axes: BodyReference(**axes),
    ),
    "set_gains": _Kind(gain_values, gains_of),
}
"""By the name of the controller's method."""


def plain_argument(name: str, *arguments: Any) -> Any:
    """Return a call's argument as JSON knows it; raises Error for a call that no tape keeps."""
    kind = _kind(name)
    if len(arguments) != (kind.plain is not None):
        expected = "none" if kind.plain is None else "one"
        raise Error(f"call '{name}': got {len(arguments)} arguments, expected {expected}")
    try:
        return kind.plain(*arguments) if kind.plain is not None else None
    except (AttributeError, TypeError):
        raise Error(f"call '{name}': got {arguments[0]!r}, which {name}() does not take") from None


def carry_out(controller: Any, name: str, argument: Any) -> str:
    """Make a call again and return the name of what it answers, "" for nothing; raises Error."""
    kind = _kind(name)
    method = getattr(controller, name, None)
    if method is None:
        raise Error(f"log: got call '{name}', which {type(controller).__name__} has not")
    try:
        arguments = () if kind.back is None else (kind.back(argument),)
    except (KeyError, TypeError, AttributeError) as problem:
        raise Error(f"log: call '{name}': got argument {argument!r} ({problem})") from None
    return answer_name(method(*arguments))


def answer_name(answer: Any) -> str:
    """Return the name of a RequestStatus, or "" for what is none."""
    return answer.name if isinstance(answer, RequestStatus) else ""


def _kind(name: str) -> _Kind:
    if name not in CALLS:
        raise Error(f"call: got '{name}', expected one of {', '.join(CALLS)}")
    return CALLS[name]
