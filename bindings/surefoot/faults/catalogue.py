"""The whole matrix: rows by injections by modes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase

from surefoot._core import Error
from surefoot.faults.case import Case, Row
from surefoot.faults.expectation import Expectation
from surefoot.faults.rows import (
    attitude,
    body,
    feet,
    healthy,
    imu,
    joints,
    link,
    low_state,
    motors,
    operation,
    power,
    wiring,
)

ROWS: tuple[Row, ...] = (
    *(*healthy.ROWS, *low_state.ROWS, *link.ROWS, *attitude.ROWS, *imu.ROWS, *feet.ROWS),
    *(*joints.ROWS, *wiring.ROWS, *motors.ROWS, *power.ROWS, *body.ROWS, *operation.ROWS),
)


@dataclass(frozen=True)
class Cell:
    """One field of the matrix.

    Attributes:
        row: Of the catalogue.
        case: One of its injections.
        number: Among the row's cases of that injection, from 1.
        mode: In which it begins.
    """

    row: Row
    case: Case
    number: int
    mode: str

    @property
    def id(self) -> str:
        """ROW/INJECTION/MODE, with a number where the row has several of that injection."""
        number = str(self.number) if self.number > 1 else ""
        return f"{self.row.id}/{self.case.injection}{number}/{self.mode}"

    @property
    def starts_standing(self) -> bool:
        """Can a robot that is taken over as it stands come to where it begins?"""
        return self.mode in ("standing", "pushed") and not self.case.make_fault().from_start

    @property
    def expectation(self) -> Expectation:
        """What is expected."""
        return self.case.expectations[self.mode]


def all_cells() -> list[Cell]:
    """Return the whole matrix, row by row."""
    cells = []
    for row in ROWS:
        numbers: dict[str, int] = {}
        for case in row.cases:
            number = numbers[case.injection] = numbers.get(case.injection, 0) + 1
            cells += [Cell(row, case, number, mode) for mode in case.expectations]
    return cells


def choose_cells(patterns: Sequence[str] = (), taken_over: bool = False) -> list[Cell]:
    """Return the cells that any of the patterns fits; all without patterns.

    Args:
        patterns: A row's id, or ROW/INJECTION/MODE with * and ? as in file names.
        taken_over: Only those that a robot comes to that is taken over as it stands.

    Raises:
        Error: A pattern that fits none.
    """
    cells = [cell for cell in all_cells() if cell.starts_standing or not taken_over]
    if not patterns:
        return cells
    for pattern in patterns:
        if not any(_matches(cell, pattern) for cell in cells):
            raise Error(
                f"--only: got '{pattern}', expected a row or ROW/INJECTION/MODE with * and ?; "
                f"{_suggestions(cells, pattern)}"
            )
    return [cell for cell in cells if any(_matches(cell, pattern) for pattern in patterns)]


def find_cell(name: str) -> Cell:
    """Return the cell of an id; raises Error."""
    return choose_cells([name])[0]


def _suggestions(cells: Sequence[Cell], pattern: str) -> str:
    """Return what there is: of the row that a pattern begins with, or, without one, rows."""
    row = [cell.id for cell in cells if fnmatchcase(cell.row.id, pattern.partition("/")[0])]
    if row:
        return f"cells: {', '.join(row)}"
    return f"rows: {', '.join(dict.fromkeys(cell.row.id for cell in cells))}"


def _matches(cell: Cell, pattern: str) -> bool:
    return fnmatchcase(cell.id, pattern) or fnmatchcase(cell.row.id, pattern)
