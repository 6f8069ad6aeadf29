"""Table of numbers that a reader takes from a file, before its clock is read."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from surefoot.geometry.batch_rotations import Array


def row_place(row: int) -> str:
    """Return the name of a row of arrays, for messages."""
    return f"row {row} (counted from 0)"


@dataclass(frozen=True)
class LogTable:
    """Columns of a file under the names of column_definitions.COLUMNS.

    Attributes:
        columns: Arrays (n, width) by name.
        ignored: Unknown names in the file.
        notes: What the reader converted or left out, one sentence each.
        place: Function that returns the place of a row in the file, for messages ("line 7").
        time_unit: Unit that the file's name of the column `time` states; None if it states none.
    """

    columns: dict[str, Array]
    ignored: list[str]
    notes: list[str] = field(default_factory=list)
    place: Callable[[int], str] = row_place
    time_unit: str | None = None
