"""Reader of CSV logs: a header of column names, then one number per cell."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from surefoot._core import Error
from surefoot.sensor_log.column_components import ColumnComponents
from surefoot.sensor_log.column_definitions import COLUMN_BY_NAME
from surefoot.sensor_log.column_map import ColumnMap
from surefoot.sensor_log.csv_decoding import decode_csv
from surefoot.sensor_log.csv_lines import CsvLines, read_lines
from surefoot.sensor_log.csv_numbers import read_numbers
from surefoot.sensor_log.file_checks import MAX_TEXT_BYTES, check_log_file, printable_path
from surefoot.sensor_log.foreign_names import stamp_part
from surefoot.sensor_log.joint_arrays import JointArrays
from surefoot.sensor_log.log_table import LogTable


def read_csv(path: Path, column_map: ColumnMap) -> LogTable:
    """Read the columns of a CSV file.

    Cells are separated by commas, semicolons, tabs or blanks. An empty cell is NaN. Blank lines
    and repeated headers are left out, and so is a last line that was cut off.

    Raises:
        Error: The file is empty, too large or has no header, a cell is not a number, or a row has
            the wrong length.
    """
    source = printable_path(path)
    size = check_log_file(path)
    if size > MAX_TEXT_BYTES:
        raise Error(
            f"{source}: got a CSV file of {size / 1e6:.0f} MB, expected up to "
            f"{MAX_TEXT_BYTES / 1e6:.0f} MB; split it, or write it as NPZ"
        )
    text, notes = decode_csv(source, path.read_bytes())
    lines = read_lines(source, text)
    components, places = _find_columns(lines, column_map)
    used = sorted({place for group in places.values() for place in group})
    if components.nanoseconds is not None:
        used.append(components.nanoseconds)
    lines, table = read_numbers(lines, used)
    if len(table) == 0:
        raise Error(f"{source}: got a header and no rows, expected one row per LowState")
    order = {place: k for k, place in enumerate(used)}
    columns = {name: table[:, [order[p] for p in group]] for name, group in places.items()}
    if components.nanoseconds is not None:
        # Subtract the first second: float64 cannot hold nanoseconds since 1970.
        seconds = columns["time"] - columns["time"][:1]
        columns["time"] = seconds + 1e-9 * table[:, [order[components.nanoseconds]]]
    numbers = np.array(lines.numbers)
    return LogTable(
        columns,
        components.ignored,
        [*notes, *lines.notes],
        lambda row: f"line {numbers[row]}",
        components.time_unit,
    )


def _find_columns(
    lines: CsvLines, column_map: ColumnMap
) -> tuple[ColumnComponents[int], dict[str, list[int]]]:
    """Return the components of the header, and the places of each column's components.

    Raises:
        Error: A name is there twice, or a column is missing or incomplete.
    """
    column_map.check_names(lines.source, lines.header)
    components: ColumnComponents[int] = ColumnComponents(lines.source, column_map)
    joints = JointArrays(lines)
    stamps = _stamp_places(lines.header, column_map)
    if stamps:
        components.add(lines.header[stamps["s"]], COLUMN_BY_NAME["time"], 0, stamps["s"])
        components.nanoseconds = stamps["ns"]
    for place, name in enumerate(lines.header):
        if place in stamps.values() or (column_map.find(name) is None and joints.add(name, place)):
            continue
        found = components.find(name)
        if found is None:
            continue
        column, index = found
        if index is None and column.width > 1:
            raise Error(
                f"{lines.source}: column '{name}': got 1 number per row, expected {column.width} "
                f"columns: {column.component(0)} .. {column.component(column.width - 1)}"
            )
        components.add(name, column, index or 0, place)
    for name, column_name, motor, place in joints.found():
        components.add(name, COLUMN_BY_NAME[column_name], motor, place)
    return components, components.ordered()


def _stamp_places(header: list[str], column_map: ColumnMap) -> dict[str, int]:
    """Return the places of the seconds "s" and nanoseconds "ns" of a ROS stamp; {} without both."""
    if column_map.has(COLUMN_BY_NAME["time"]):
        return {}
    parts = [(stamp_part(name.strip().lower()), place) for place, name in enumerate(header)]
    places = {part: place for part, place in reversed(parts) if part is not None}
    return places if len(places) == 2 else {}
