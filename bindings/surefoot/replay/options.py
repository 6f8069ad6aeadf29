"""Options of controllers as plain data, to the last bit, and back."""

from __future__ import annotations

from enum import Enum
from typing import Any, TypeVar

from surefoot._core import Error, StandOptions

Options = TypeVar("Options")


def plain_options(options: Any) -> dict[str, Any]:
    """Return every option by name; enums by theirs, options within options the same way."""
    return {name: _plain(getattr(options, name)) for name in _names(options)}


def options_of(values: dict[str, Any], start: Options) -> Options:
    """Write options by name into `start`, which has all of them, and return it; raises Error."""
    if set(values) != set(_names(start)):
        differing = ", ".join(sorted(set(values) ^ set(_names(start))))
        raise Error(f"log: got other options than this version has: {differing}")
    for name, value in values.items():
        own = getattr(start, name)
        if isinstance(own, StandOptions):
            value = options_of(value, StandOptions())
        elif isinstance(own, Enum):
            if value not in type(own).__members__:
                names = ", ".join(type(own).__members__)
                raise Error(f"log: option '{name}': got {value!r}, expected one of {names}")
            value = type(own)[value]
        setattr(start, name, value)
    return start


def _names(options: Any) -> list[str]:
    return [name for name in dir(options) if not name.startswith("_")]


def _plain(value: Any) -> Any:
    if isinstance(value, StandOptions):
        return plain_options(value)
    return value.name if isinstance(value, Enum) else value
