"""Lines of a CSV file: its header, its rows, and what was left out."""

from __future__ import annotations

import csv
import re
from dataclasses import dataclass

from surefoot._core import Error

DELIMITERS = ",;\t"
# Chosen: a dump of a LowState has 400 columns, 10 kB a line. Longer lines, or more of them, would
# take much more memory than the file.
MAX_LINE_LENGTH = 1_000_000
MAX_LINES = 10_000_000
_BLANK = ' ,;\t"'  # characters of a line without content


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
    lines = _split_lines(source, text)
    filled = [k for k, line in enumerate(lines) if line.strip(_BLANK)]
    place, delimiter = _header_place(lines, filled)
    if place is None:
        raise Error(f"{source}: got an empty file, expected a header of column names and rows")
    header_line = lines[place]
    if delimiter is None:
        delimiter = max(DELIMITERS, key=header_line.count)
        delimiter = delimiter if delimiter in header_line else None
    cells = split_cells(source, header_line.lstrip("# "), place + 1, delimiter)
    header = [cell.strip() for cell in cells]
    header[0] = header[0].lstrip("# ")
    if all(is_number(name) for name in header if name):
        raise Error(f"{source}: line {place + 1}: got numbers, expected a header of column names")
    below = [k for k in filled if k > place]
    repeated = {k for k in below if lines[k].strip(_BLANK + "#") == header_line.strip(_BLANK + "#")}
    comments = {k for k in below if lines[k].lstrip(' "').startswith("#")} - repeated
    notes = []
    if repeated:
        notes.append(
            f"line {min(repeated) + 1}: the header is repeated {len(repeated)} times; the repeated "
            "lines are left out"
        )
    if comments:
        notes.append(f"line {min(comments) + 1}: {len(comments)} comment lines are left out")
    rows = [k for k in below if k not in repeated and k not in comments]
    return CsvLines(
        source,
        header,
        delimiter,
        [lines[k] for k in rows],
        [k + 1 for k in rows],
        text.endswith("\n"),
        notes,
    )


def _split_lines(source: str, text: str) -> list[str]:
    """Return the lines of a text.

    Raises:
        Error: The text has too many lines or a line is too long for a log.
    """
    count = text.count("\n")
    if count > MAX_LINES:
        raise Error(f"{source}: got {count} lines, expected up to {MAX_LINES}; split the log")
    lines = text.split("\n")
    longest = max(range(len(lines)), key=lambda k: len(lines[k]))
    if len(lines[longest]) > MAX_LINE_LENGTH:
        raise Error(
            f"{source}: line {longest + 1}: got {len(lines[longest])} characters, expected up to "
            f"{MAX_LINE_LENGTH}; is it a CSV file?"
        )
    return lines


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
        if line.lstrip('"').startswith("#") and not _starts_with_number(following):
            continue
        return place, delimiter
    return None, delimiter


def _starts_with_number(line: str) -> bool:
    words = re.split(r'[;,\s"]+', line.strip(' "'))
    return is_number(words[0])


def split_cells(source: str, line: str, number: int, delimiter: str | None) -> list[str]:
    """Return the cells of a line; cells may be quoted.

    Raises:
        Error: The quotes of the line are not closed.
    """
    if delimiter is None:
        return line.split()
    if '"' not in line:
        return line.split(delimiter)
    line = re.sub(f" *{delimiter} *", delimiter, line.strip(" "))  # csv wants quotes at the ends
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
