"""Write a log to a file that read_log() reads."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from surefoot.files.tables import check_table_name, write_table
from surefoot.sensor_log.column_definitions import COLUMNS
from surefoot.sensor_log.sensor_log import SensorLog


def write_log(
    path: str | Path, log: SensorLog, extras: Mapping[str, np.ndarray] | None = None
) -> None:
    """Write a log as CSV or NPZ, depending on the suffix of the file.

    Sensor values are written in the types of LowState (float32, int16, tick as uint32), so an
    estimator receives bit-identical values when the file is read back.

    Args:
        path: The file.
        log: The log.
        extras: Further arrays for an NPZ file, with names ``replay_...`` (see
            replay/recording_file.py) or ``run_...``. A CSV file omits these arrays.

    Raises:
        Error: The suffix is neither .csv nor .npz.
        OSError: The file cannot be written.
    """
    path = check_table_name(path, "log")
    table: dict[str, np.ndarray] = {}
    for column in COLUMNS:
        if column.name in log.columns:
            values = log.columns[column.name]
            table[column.name] = _as_low_state_type(column.name, values, column.width)
    if extras is not None and path.suffix.lower() == ".npz":
        table.update(extras)
    write_table(path, table)


def _as_low_state_type(name: str, values: np.ndarray, width: int) -> np.ndarray:
    """Convert a column (n, width) to the type of its LowState field; return (n,) if width is 1.

    An integer column with NaN or infinity keeps its type. So do `time` and ``truth_...`` columns.
    """
    integer_type = {"tick": np.uint32, "footForce": np.int16, "footForceEst": np.int16}.get(name)
    if integer_type is not None and np.isfinite(values).all():
        values = values.astype(np.int64).astype(
            integer_type
        )  # through int64, so that out-of-range values wrap on every machine
    elif integer_type is None and name != "time" and not name.startswith("truth_"):
        values = values.astype(np.float32)
    return values[:, 0] if width == 1 else values
