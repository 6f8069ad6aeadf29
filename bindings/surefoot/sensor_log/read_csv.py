"""Reader of CSV logs: a header of column names, then one number per cell."""

from __future__ import annotations

import csv
import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from surefoot._core import Error
from surefoot.geometry.batch_rotations import Array
from surefoot.sensor_log.column_components import ColumnComponents

_DELIMITERS = ",;\t"


def read_csv(path: Path) -> tuple[dict[str, Array], list[str]]:
    """Return the columns (n, width) by name, and the unknown names in the file.

    Cells are separated by commas, semicolons or tabs. An empty cell is NaN.

    Raises:
        Error: The file is empty or has no header, a cell is not a number, or a row has the wrong
            length.
    """
    with path.open(encoding="utf-8-sig", newline="") as file:
        line = file.readline()
    if not line.strip():
        raise Error(f"{path}: got an empty file, expected a header of column names and rows")
    delimiter = max(_DELIMITERS, key=line.count)
    header = [name.strip() for name in next(csv.reader([line.lstrip("# ")], delimiter=delimiter))]
    if all(_is_number(name) for name in header):
        raise Error(f"{path}: row 1: got numbers, expected a header of column names")
    components: ColumnComponents[int] = ColumnComponents(str(path))
    for place, name in enumerate(header):
        found = components.find(name)
        if found is None:
            continue
        column, index = found
        if index is None and column.width > 1:
            raise Error(
                f"{path}: column '{name}': got 1 number per row, expected {column.width} columns: "
                f"{column.component(0)} .. {column.component(column.width - 1)}"
            )
        components.add(name, column, index or 0, place)
    places = components.ordered()
    used = sorted(place for group in places.values() for place in group)
    table = _read_table(path, delimiter, header, used)
    if len(table) == 0:
        raise Error(f"{path}: got a header and no rows, expected one row per LowState")
    order = {place: k for k, place in enumerate(used)}
    columns = {name: table[:, [order[p] for p in group]] for name, group in places.items()}
    return columns, components.ignored


def _read_table(path: Path, delimiter: str, header: Sequence[str], used: Sequence[int]) -> Array:
    """Return the file columns with the indices `used` as numbers, shape (n, len(used))."""
    with path.open(encoding="utf-8-sig", newline="") as file:
        file.readline()
        if not file.readline().strip():
            return np.zeros((0, len(used)))
    try:
        return np.loadtxt(
            path, delimiter=delimiter, skiprows=1, usecols=used, ndmin=2, encoding="utf-8-sig"
        )
    except (ValueError, IndexError):
        return _read_cells(
            path, delimiter, header, used
        )  # slower, but accepts empty and quoted cells; raises Error for other text


def _read_cells(path: Path, delimiter: str, header: Sequence[str], used: Sequence[int]) -> Array:
    rows = []
    with path.open(encoding="utf-8-sig", newline="") as file:
        reader = csv.reader(file, delimiter=delimiter)
        next(reader)
        for cells in reader:
            if not any(cells):
                continue
            if len(cells) != len(header):
                raise Error(
                    f"{path}: row {reader.line_num}: got {len(cells)} cells, expected "
                    f"{len(header)} as in the header"
                )
            rows.append([_number(cells[k], path, reader.line_num, header[k]) for k in used])
    return np.array(rows).reshape(-1, len(used))


def _number(cell: str, path: Path, row: int, name: str) -> float:
    if not cell.strip():
        return math.nan
    try:
        return float(cell)
    except ValueError:
        raise Error(
            f"{path}: row {row}, column '{name}': got '{cell}', expected a number"
        ) from None


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
