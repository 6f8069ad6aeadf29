"""Read a log from a file."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from surefoot._core import Error
from surefoot.geometry.batch_rotations import Array
from surefoot.sensor_log.clock import read_clock
from surefoot.sensor_log.column_definitions import COLUMN_BY_NAME, REQUIRED_COLUMNS
from surefoot.sensor_log.read_csv import read_csv
from surefoot.sensor_log.read_npz import read_npz
from surefoot.sensor_log.sensor_log import SensorLog

_READERS = {".csv": read_csv, ".npz": read_npz}


def read_log(path: str | Path) -> SensorLog:
    """Read a log from a CSV or NPZ file.

    column_definitions.COLUMNS lists the columns that a log may have. A clock (tick or time),
    gyroscope, accelerometer and q are required. The log omits unknown columns and lists them in
    `ignored`. It keeps rows with NaN.

    Raises:
        Error: The file cannot be read; a column is missing, duplicate or malformed; or the clock
            does not advance.
    """
    path = Path(path)
    reader = _READERS.get(path.suffix.lower())
    if reader is None:
        raise Error(f"log: got '{path}', expected a file whose name ends in .csv or .npz")
    try:
        columns, ignored = reader(path)
    except OSError as problem:
        raise Error(f"log: cannot read '{path}': {problem.strerror or problem}") from None
    except UnicodeDecodeError:
        raise Error(f"{path}: got bytes that are not UTF-8, expected a CSV file in UTF-8") from None
    warnings = _drop_never_finite(str(path), columns)
    clock, time = read_clock(str(path), columns)
    if clock == "time" and "tick" in columns:
        warnings.append("tick is constant: the clock is time")
    columns.pop("mode", None)
    return SensorLog(str(path), columns, time, clock, tuple(ignored), tuple(warnings))


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
