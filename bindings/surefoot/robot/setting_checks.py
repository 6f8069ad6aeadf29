"""Checks of settings; each message has the form "<name>: got X, expected Y"."""

from __future__ import annotations

import math
from typing import Any

from surefoot._core import Error


def check_one_of(name: str, value: Any, valid: tuple[str, ...], note: str = "") -> None:
    """Raise Error unless a value is one of the valid names; the message ends with `note`."""
    if value not in valid:
        raise Error(f"{name}: got {value!r}; valid names: {', '.join(valid)}{note}")


def check_integer(name: str, value: Any, low: int, high: int) -> None:
    """Raise Error unless a value is an integer in [low, high]."""
    if isinstance(value, bool) or not isinstance(value, int) or not low <= value <= high:
        raise Error(f"{name}: got {value!r}, expected a whole number {low} .. {high}")


def check_number(name: str, value: Any, low: float, high: float) -> None:
    """Raise Error unless a value is a number in [low, high]."""
    try:
        converted = math.nan if isinstance(value, bool | str) else float(value)
    except (TypeError, ValueError, OverflowError):
        converted = math.nan
    if not low <= converted <= high:
        raise Error(f"{name}: got {value!r}, expected a number from {low:g} to {high:g}")


def check_numbers(name: str, values: Any, low: float, high: float) -> None:
    """Raise Error unless `values` is a non-empty tuple of numbers in [low, high]."""
    if not isinstance(values, tuple) or not values:
        raise Error(f"{name}: got {values!r}, expected a tuple of numbers (TOML: a list)")
    for value in values:
        check_number(name, value, low, high)


def check_unique(name: str, values: tuple[float, ...]) -> None:
    """Raise Error if two numbers have the same text in format g, as in stores and tables."""
    formatted = [f"{value:g}" for value in values]
    if len(set(formatted)) < len(formatted):
        raise Error(f"{name}: got {', '.join(formatted)}, expected each once")
