"""Check of a number's range."""

from __future__ import annotations

from surefoot._core import Error


def check_range(name: str, value: float, low: float, high: float, unit: str = "") -> None:
    """Raise Error unless low <= value <= high; NaN also raises Error."""
    if not low <= value <= high:
        unit_suffix = f" {unit}" if unit else ""
        raise Error(
            f"{name}: got {value:g}{unit_suffix}, expected {low:g} .. {high:g}{unit_suffix}"
        )
