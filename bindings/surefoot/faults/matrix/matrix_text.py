"""Result of a fault matrix as text."""

from __future__ import annotations

import textwrap
from typing import Any

from surefoot.faults.case import MODES
from surefoot.faults.catalogue import Cell

MARKS = {"pass": "ok", "fail": "FAIL"}
_WIDTH = 46  # [characters] width of the column with the descriptions of injections


def faults_text(result: dict[str, Any]) -> str:
    """Return the result of a matrix as a text table with a line per case and a column per mode."""
    total = result["passed"] + result["failed"]
    title = f"{result['robot']}, seed {result['seed']}, power level {result['power_level']}"
    title += ", taken over standing" if result["taken_over"] else ""
    lines = [title, "", _line("", "", "expected", MODES)]
    row = ""
    for name, cells in by_injection(result["cells"]).items():
        first = next(iter(cells.values()))
        if first["row"] != row:
            row = first["row"]
            lines += ["", row]
        marks = [MARKS[cells[mode]["verdict"]] if mode in cells else "-" for mode in MODES]
        expected = next((c["expected"] for m, c in cells.items() if m != "lying"), "")
        lines.append(_line(first["injection"], first["what"], expected or first["expected"], marks))
        assert name
    lines += ["", f"{result['passed']} of {total} cells passed"]
    for failure in result["failures"]:
        lines += textwrap.wrap(f"{failure['id']}: {failure['reason']}", 110, subsequent_indent="  ")
    return "\n".join(lines)


def by_injection(cells: list[dict[str, Any]]) -> dict[str, dict[str, dict[str, Any]]]:
    """Group the results of cells by ROW/INJECTION.

    Returns:
        The results by mode, by ROW/INJECTION.
    """
    lines: dict[str, dict[str, dict[str, Any]]] = {}
    for cell in cells:
        lines.setdefault(cell["id"].rpartition("/")[0], {})[cell["mode"]] = cell
    return lines


def list_text(cells: list[Cell]) -> str:
    """Return a text with a line for each cell: id, expected reaction, time limit, description."""
    width = max(len(cell.id) for cell in cells)
    return "\n".join(
        f"{cell.id.ljust(width)}  {cell.expectation.reaction.value}{_within(cell)}: "
        f"{cell.case.description}"
        for cell in cells
    )


def _within(cell: Cell) -> str:
    within = cell.expectation.within
    return f" within {1e3 * within:.0f} ms" if within > 0.0 else ""


def _line(injection: str, what: str, expected: str, marks: Any) -> str:
    columns = "".join(str(mark).rjust(10) for mark in marks)
    return f"  {injection:<13}{what[:_WIDTH]:<{_WIDTH + 2}}{expected:<9}{columns}".rstrip()
