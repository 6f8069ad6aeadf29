"""Description of the numbers in a summary."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Field:
    """One entry of a summary.

    Attributes:
        name: Key in the summary.
        unit: Unit; "" for words, counts and ratios.
        meaning: Meaning in one sentence or less.
        group: Heading of its part of the table.
    """

    name: str
    unit: str
    meaning: str
    group: str
