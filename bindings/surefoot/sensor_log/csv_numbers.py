"""Convert the rows of a CSV file to numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from surefoot._core import Error
from surefoot.geometry.batch_rotations import Array
from surefoot.sensor_log.csv_lines import CsvLines, is_number

_CHUNK = 4096  # rows converted at a time; a chunk with unusual cells is converted cell by cell


def read_numbers(lines: CsvLines, used: Sequence[int]) -> tuple[CsvLines, Array]:
    """Return the rows that are complete, and their columns `used` as numbers (n, len(used)).

    A last line that was cut off is left out, and decimal commas are converted; the notes of the
    returned lines say so. Empty cells are NaN.

    Raises:
        Error: A row has another number of cells than the header, or a cell is not a number. The
            message names the line, the column and the text.
    """
    lines = _without_cut_line(_with_decimal_points(lines, used), used)
    _check_cell_counts(lines)
    parts = [
        _convert(lines, used, start, min(start + _CHUNK, len(lines.rows)))
        for start in range(0, len(lines.rows), _CHUNK)
    ]
    return lines, np.concatenate(parts) if parts else np.zeros((0, len(used)))


def _convert(lines: CsvLines, used: Sequence[int], start: int, end: int) -> Array:
    rows = lines.rows[start:end]
    if not any('"' in row for row in rows):
        try:
            return np.loadtxt(rows, delimiter=lines.delimiter, usecols=used, ndmin=2, comments=None)
        except (ValueError, IndexError):  # an empty cell, or text
            pass
    return np.array([_row_numbers(lines, used, row) for row in range(start, end)])


def _row_numbers(lines: CsvLines, used: Sequence[int], row: int) -> list[float]:
    cells = lines.cells(row)
    numbers = []
    for k in used:
        cell = cells[k].strip()
        if cell and not is_number(cell):
            raise Error(
                f"{lines.source}: line {lines.numbers[row]}, column '{lines.header[k]}': got "
                f"'{cell[:40]}', expected a number"
            )
        numbers.append(float(cell) if cell else math.nan)
    return numbers


def _cell_count(lines: CsvLines, row: int) -> int:
    """Return the number of cells of a row; a delimiter at its end does not begin a cell."""
    cells = lines.cells(row)
    surplus = len(cells) == len(lines.header) + 1 and not cells[-1].strip()
    return len(cells) - surplus


def _check_cell_counts(lines: CsvLines) -> None:
    count = len(lines.header)
    for row, text in enumerate(lines.rows):
        if lines.delimiter is not None and '"' not in text:
            if text.count(lines.delimiter) == count - 1:
                continue
        got = _cell_count(lines, row)
        if got == count:
            continue
        commas = lines.delimiter == "," and got >= 1.5 * count
        hint = "; if the numbers have decimal commas, separate the cells by ';'" if commas else ""
        raise Error(
            f"{lines.source}: line {lines.numbers[row]}: got {got} cells, expected {count} as in "
            f"the header{hint}"
        )


def _without_cut_line(lines: CsvLines, used: Sequence[int]) -> CsvLines:
    """Return the lines without the last one if it was cut off."""
    if not lines.rows or not _is_cut(lines, used):
        return lines
    note = f"line {lines.numbers[-1]}: the last line is cut off and is left out"
    return replace(
        lines, rows=lines.rows[:-1], numbers=lines.numbers[:-1], notes=[*lines.notes, note]
    )


def _is_cut(lines: CsvLines, used: Sequence[int]) -> bool:
    last = len(lines.rows) - 1
    try:
        cells = lines.cells(last)
    except Error:  # a quote that is not closed
        return not lines.ended
    if len(cells) < len(lines.header):
        return True
    if lines.ended or len(cells) > len(lines.header) or len(cells) - 1 not in used:
        return False
    # No line end: the last cell may lack digits. It does if it is no number, or shorter than
    # every other cell of its column.
    cell = cells[-1].strip()
    if not is_number(cell) and cell:
        return all(is_number(lines.cells(row)[-1].strip() or "0") for row in range(last))
    shortest = min((len(lines.cells(row)[-1].strip()) for row in range(last)), default=0)
    return len(cell) < shortest


def _with_decimal_points(lines: CsvLines, used: Sequence[int]) -> CsvLines:
    """Return the lines with decimal points instead of decimal commas.

    Raises:
        Error: Some cells have decimal commas and others decimal points.
    """
    if lines.delimiter == ",":
        return lines
    comma = _first_cell_with(",", lines, used)
    if comma is None:
        return lines
    point = _first_cell_with(".", lines, used)
    row, column = comma if point is None else max(comma, point)
    name = lines.header[column]
    if point is not None:
        cell = lines.cells(row)[column].strip()
        raise Error(
            f"{lines.source}: line {lines.numbers[row]}, column '{name}': got '{cell[:40]}' in a "
            "file with decimal commas and decimal points, expected one of them"
        )
    note = f"line {lines.numbers[row]}, column '{name}': decimal commas are read as points"
    rows = [text.replace(",", ".") for text in lines.rows]
    return replace(lines, rows=rows, notes=[*lines.notes, note])


def _first_cell_with(mark: str, lines: CsvLines, used: Sequence[int]) -> tuple[int, int] | None:
    """Return row and column of the first used cell that contains a character."""
    for row, text in enumerate(lines.rows):
        if mark in text:
            for k, cell in enumerate(lines.cells(row)):
                if mark in cell and k in used:
                    return row, k
    return None
