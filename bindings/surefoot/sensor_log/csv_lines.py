"""Lines of a CSV file: its header, its rows, and what was left out."""

from __future__ import annotations

import csv
from dataclasses import dataclass

from surefoot._core import Error

DELIMITERS = ",;\t"


@dataclass(frozen=True)
class CsvLines:
    """Header and rows of a CSV file.

    Attributes:
        source: Name of the file, for messages.
        header: Names of the file's columns.
        delimiter: Character between cells; None for blanks.
        rows: Text of each row. Blank lines and repeated headers are left out.
        numbers: Number of each row's line in the file, counted from 1.
        ended: True if the last line has a line end.
        notes: What was left out, one sentence each.
    """

    source: str
    header: list[str]
    delimiter: str | None
    rows: list[str]
    numbers: list[int]
    ended: bool
    notes: list[str]

    def cells(self, row: int) -> list[str]:
        """Return the cells of a row."""
        return split_cells(self.source, self.rows[row], self.numbers[row], self.delimiter)


def read_lines(source: str, text: str) -> CsvLines:
    """Find the header and the rows of a CSV file.

    Raises:
        Error: The file is empty, or its first line has numbers instead of names.
    """
    lines = text.split("\n")
    filled = [k for k, line in enumerate(lines) if line.strip(" \t,;")]
    place, delimiter = _header_place(lines, filled)
    if place is None:
        raise Error(f"{source}: got an empty file, expected a header of column names and rows")
    header_line = lines[place]
    if delimiter is None:
        delimiter = max(DELIMITERS, key=header_line.count)
        delimiter = delimiter if delimiter in header_line else None
    header = split_cells(source, header_line.lstrip("# "), place + 1, delimiter)
    header = [name.strip() for name in header]
    if all(is_number(name) for name in header if name):
        raise Error(f"{source}: line {place + 1}: got numbers, expected a header of column names")
    below = [k for k in filled if k > place]
    rows = [k for k in below if lines[k].strip() != header_line.strip()]
    notes = []
    if len(rows) < len(below):
        first = next(k for k in below if lines[k].strip() == header_line.strip())
        notes.append(
            f"line {first + 1}: the header is repeated {len(below) - len(rows)} times; the "
            "repeated lines are left out"
        )
    return CsvLines(
        source,
        header,
        delimiter,
        [lines[k] for k in rows],
        [k + 1 for k in rows],
        text.endswith("\n"),
        notes,
    )


def _header_place(lines: list[str], filled: list[int]) -> tuple[int | None, str | None]:
    """Return the index of the header's line, and the delimiter that a line "sep=;" declares.

    Comment lines before the header begin with #. The header may begin with # too: then numbers
    follow.
    """
    delimiter = None
    for k, place in enumerate(filled):
        line = lines[place].strip()
        if k == 0 and line.lower().startswith("sep=") and len(line) == 5:
            delimiter = line[4]
            continue
        following = lines[filled[k + 1]] if k + 1 < len(filled) else ""
        if line.startswith("#") and not _starts_with_number(following):
            continue
        return place, delimiter
    return None, delimiter


def _starts_with_number(line: str) -> bool:
    words = line.replace(";", " ").replace("\t", " ").replace(",", " ").split()
    return bool(words) and is_number(words[0])


def split_cells(source: str, line: str, number: int, delimiter: str | None) -> list[str]:
    """Return the cells of a line; cells may be quoted.

    Raises:
        Error: The quotes of the line are not closed.
    """
    if delimiter is None:
        return line.split()
    if '"' not in line:
        return line.split(delimiter)
    try:
        return next(csv.reader([line], delimiter=delimiter, strict=True))
    except csv.Error as problem:
        raise Error(
            f'{source}: line {number}: got wrong quotes ({problem}), expected pairs of "'
        ) from None


def is_number(text: str) -> bool:
    """Return whether a cell is a decimal number, NaN or infinity."""
    try:
        float(text)
    except ValueError:
        return False
    return text.isascii() and "_" not in text
