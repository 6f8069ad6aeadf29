"""Description of the numbers in a summary."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Field:
    """One entry of a summary.

    Attributes:
        name: Key in the summary.
        unit: Unit; "" for words, counts and ratios.
        meaning: Meaning of the number in at most one sentence.
        group: Heading of the part of the table that shows the number.
    """

    name: str
    unit: str
    meaning: str
    group: str
