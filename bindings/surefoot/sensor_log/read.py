"""Read a log from a file."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from surefoot._core import Error
from surefoot.geometry.batch_rotations import Array
from surefoot.sensor_log.clock import read_clock
from surefoot.sensor_log.column_definitions import (
    CLOCK_COLUMNS,
    COLUMN_BY_NAME,
    FOOT_COLUMNS,
    REQUIRED_COLUMNS,
    SENSOR_COLUMNS,
)
from surefoot.sensor_log.column_map import ColumnMap, read_column_map
from surefoot.sensor_log.file_checks import printable_path
from surefoot.sensor_log.log_table import LogTable
from surefoot.sensor_log.read_bag import is_bag, read_bag
from surefoot.sensor_log.read_csv import read_csv
from surefoot.sensor_log.read_npz import read_npz
from surefoot.sensor_log.sensor_log import SensorLog

_READERS: dict[str, Callable[[Path, ColumnMap], LogTable]] = {".csv": read_csv, ".npz": read_npz}


def read_log(path: str | Path, columns: str | Path | None = None) -> SensorLog:
    """Read a log from a CSV or NPZ file, or from a ROS 2 bag.

    column_definitions.COLUMNS lists the columns that a log may have. A clock (tick or time),
    gyroscope, accelerometer and q are required. The log omits unknown columns and lists them in
    `ignored`. It keeps rows with NaN, which the estimator leaves out. `notes` says what was
    converted or left out.

    Args:
        path: The file; a bag is a folder, a .db3 or an .mcap file.
        columns: TOML file that gives the names of the columns in the log; see read_column_map().

    Raises:
        Error: The file cannot be read; a column is missing, duplicate or malformed; or the clock
            goes backwards or does not advance. The message names the line and the column.
    """
    path = Path(path)
    source = printable_path(path)
    column_map = ColumnMap() if columns is None else read_column_map(columns)
    reader = read_bag if is_bag(path) else _READERS.get(path.suffix.lower())
    if reader is None:
        raise Error(
            f"log: got '{source}', expected a file whose name ends in .csv or .npz, or a bag "
            "(.db3, .mcap or its folder)"
        )
    try:
        table = reader(path, column_map)
    except OSError as problem:
        raise Error(f"log: cannot read '{source}': {problem.strerror or problem}") from None
    values, notes = _within_float32(table.columns), list(table.notes)
    warnings = _drop_never_finite(source, values)
    clock, time = read_clock(source, values, table.place, notes, table.time_unit)
    notes += _non_finite_notes(values, clock, table.place)
    if clock == "time" and "tick" in values:
        warnings.append("tick is constant: the clock is time")
    values.pop("mode", None)
    return SensorLog(
        source, values, time, clock, tuple(table.ignored), tuple(warnings), tuple(notes)
    )


def _within_float32(columns: dict[str, Array]) -> dict[str, Array]:
    """Return the columns with infinity for values that a LowState, float32, cannot hold."""
    limit = float(np.finfo(np.float32).max)
    return {
        name: values
        if name in CLOCK_COLUMNS
        else np.where(np.abs(values) > limit, np.copysign(np.inf, values), values)
        for name, values in columns.items()
    }


def _drop_never_finite(source: str, columns: dict[str, Array]) -> list[str]:
    """Remove the optional columns without any finite row; return a warning for each.

    Such a column would make every row unusable.

    Raises:
        Error: A required column has no finite row.
    """
    warnings = []
    for name in list(columns):
        if np.isfinite(columns[name]).all(axis=1).any():
            continue
        if name in REQUIRED_COLUMNS or not set(columns) & {"tick", "time"} - {name}:
            raise Error(
                f"{source}: column '{name}': got NaN or infinity in every row, expected numbers"
            )
        if not COLUMN_BY_NAME[name].is_truth:
            warnings.append(f"{name} is NaN or infinite in every row and is treated as missing")
        del columns[name]
    return warnings


def _non_finite_notes(
    columns: dict[str, Array], clock: str, place: Callable[[int], str]
) -> list[str]:
    """Return a sentence for each column with NaN or infinity in some rows."""
    notes = []
    for name in (clock, *SENSOR_COLUMNS, *FOOT_COLUMNS):
        bad = ~np.isfinite(columns.get(name, np.zeros((0, 1))))
        rows = np.flatnonzero(bad.any(axis=1))
        if len(rows):
            component = COLUMN_BY_NAME[name].component(int(np.argmax(bad[rows[0]])))
            notes.append(
                f"{len(rows)} rows with NaN, infinity or an empty cell in '{name}' are left out; "
                f"the first is {place(int(rows[0]))}, column '{component}'"
            )
    return notes
