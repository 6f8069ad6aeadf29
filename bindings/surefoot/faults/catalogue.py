"""Fault catalogue: all cells of the matrix, one for each case of a row and each of its modes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase

from surefoot._core import Error
from surefoot.faults.case import ON_FEET_MODES, Case, Row
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
    """One cell of the matrix.

    Attributes:
        row: Row of the catalogue.
        case: Case of this row.
        number: Number of the case among the cases of this row with the same injection, from 1.
        mode: Mode of the robot in which the fault begins.
    """

    row: Row
    case: Case
    number: int
    mode: str

    @property
    def id(self) -> str:
        """ROW/INJECTION/MODE, for example "quaternion/wrong2/rising".

        If `number` is above 1, it follows INJECTION.
        """
        number = str(self.number) if self.number > 1 else ""
        return f"{self.row.id}/{self.case.injection}{number}/{self.mode}"

    @property
    def can_start_standing(self) -> bool:
        """True if the cell can also run with a robot that stands when the supervisor starts."""
        return self.mode in ON_FEET_MODES and not self.case.make_fault().from_start

    @property
    def expectation(self) -> Expectation:
        """Expected reaction of the case in this mode."""
        return self.case.expectations[self.mode]


def all_cells() -> list[Cell]:
    """Return all cells of the matrix, row by row."""
    cells = []
    for row in ROWS:
        numbers: dict[str, int] = {}
        for case in row.cases:
            number = numbers[case.injection] = numbers.get(case.injection, 0) + 1
            cells += [Cell(row, case, number, mode) for mode in case.expectations]
    return cells


def choose_cells(patterns: Sequence[str] = (), taken_over: bool = False) -> list[Cell]:
    """Return the cells that match any of the patterns; all cells if there are no patterns.

    Args:
        patterns: Row ids, or ROW/INJECTION/MODE with the wildcards ``*`` and ``?``.
        taken_over: True: choose only from the cells whose property can_start_standing is True.

    Raises:
        Error: A pattern matches no cell.
    """
    cells = [cell for cell in all_cells() if cell.can_start_standing or not taken_over]
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
    """Return the cell with an id.

    Raises:
        Error: No cell has this id.
    """
    return choose_cells([name])[0]


def _suggestions(cells: Sequence[Cell], pattern: str) -> str:
    """Return suggestions for a pattern: the cells of the pattern's row, or else all rows."""
    row = [cell.id for cell in cells if fnmatchcase(cell.row.id, pattern.partition("/")[0])]
    if row:
        return f"cells: {', '.join(row)}"
    return f"rows: {', '.join(dict.fromkeys(cell.row.id for cell in cells))}"


def _matches(cell: Cell, pattern: str) -> bool:
    return fnmatchcase(cell.id, pattern) or fnmatchcase(cell.row.id, pattern)
