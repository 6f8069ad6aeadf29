"""Lossless conversion of controller options to JSON values and back."""

from __future__ import annotations

from enum import Enum
from typing import Any, TypeVar

from surefoot._core import ControllerOptions, Error

Options = TypeVar("Options")


def json_options(options: Any) -> dict[str, Any]:
    """Return all options as JSON values by name; the value of an enum is its name.

    Nested ControllerOptions become a dict.
    """
    return {name: _json_value(getattr(options, name)) for name in _names(options)}


def options_from_json(values: dict[str, Any], options: Options) -> Options:
    """Set all options from JSON values.

    Args:
        values: Values of all options, as from json_options().
        options: Options that this function changes in place.

    Returns:
        The argument `options`.

    Raises:
        Error: The names of the options differ, or a value is invalid.
    """
    if set(values) != set(_names(options)):
        differing = ", ".join(sorted(set(values) ^ set(_names(options))))
        raise Error(
            f"log: got options that differ from this version's: {differing}; "
            "expected a log of this version"
        )
    for name, value in values.items():
        current = getattr(options, name)
        if isinstance(current, ControllerOptions):
            value = options_from_json(value, ControllerOptions())
        elif isinstance(current, Enum):
            if value not in type(current).__members__:
                names = ", ".join(type(current).__members__)
                raise Error(f"log: option '{name}': got {value!r}, expected one of {names}")
            value = type(current)[value]
        setattr(options, name, value)
    return options


def _names(options: Any) -> list[str]:
    return [name for name in dir(options) if not name.startswith("_")]


def _json_value(value: Any) -> Any:
    if isinstance(value, ControllerOptions):
        return json_options(value)
    return value.name if isinstance(value, Enum) else value
