"""What a number of a summary means: of a stand, of a log."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Field:
    """One entry of a summary.

    Attributes:
        name: Its key.
        unit: "" for words, counts and ratios.
        meaning: One sentence or less.
        group: Heading that it stands under.
    """

    name: str
    unit: str
    meaning: str
    group: str
