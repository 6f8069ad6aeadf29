"""Numbers of a URDF, read strictly: a decimal comma, nan or a missing number is an error."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ET

from surefoot._core import Error

_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
_SMALLEST = 1e-300  # numerical: smaller numbers are not normal, and some parsers reject them


def read_numbers(element: ET.Element, name: str, count: int, where: str) -> list[float]:
    """Return the numbers of an attribute.

    Args:
        element: The element.
        name: Name of the attribute.
        count: Expected number of numbers.
        where: Link or joint of the element, for messages.

    Raises:
        Error: The attribute is missing, has another count, or has a number that is not finite.
    """
    what = f"{where}, <{element.tag} {name}>"
    text = element.get(name)
    expected = "a number" if count == 1 else f"{count} numbers separated by spaces"
    if text is None:
        raise Error(f"{what}: got no such attribute, expected {expected}")
    words = text.split()
    if len(words) != count:
        raise Error(f"{what}: got '{text}', expected {expected}")
    return [_number(word, text, what) for word in words]


def read_number(element: ET.Element, name: str, where: str) -> float:
    """Return the number of an attribute; raise Error as read_numbers()."""
    return read_numbers(element, name, 1, where)[0]


def number_text(values: list[float]) -> str:
    """Return numbers as text for an attribute; reading it gives the same numbers."""
    return " ".join(repr(value) if abs(value) >= _SMALLEST else "0" for value in values)


def _number(word: str, text: str, what: str) -> float:
    if not _NUMBER.fullmatch(word):
        hint = " with a decimal point" if "," in word else ""
        raise Error(f"{what}: got '{text}', expected finite numbers{hint}")
    value = float(word)
    if not math.isfinite(value):
        raise Error(f"{what}: got '{text}', expected finite numbers")
    return value
