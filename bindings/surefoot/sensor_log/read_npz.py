"""Reader of NPZ logs: one array per column, or one per component."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from surefoot._core import Error
from surefoot.geometry.batch_rotations import Array
from surefoot.sensor_log.column_components import ColumnComponents
from surefoot.sensor_log.column_definitions import (
    COLUMN_BY_NAME,
    REPLAY_PREFIX,
    RUN_PREFIX,
    Column,
)
from surefoot.sensor_log.column_map import ColumnMap
from surefoot.sensor_log.file_checks import check_npz_file, printable_path, refusing_corrupt_npz
from surefoot.sensor_log.foreign_names import find_whole
from surefoot.sensor_log.log_table import LogTable


def read_npz(path: Path, column_map: ColumnMap) -> LogTable:
    """Read the columns of an NPZ file.

    Raises:
        Error: The file is not a valid NPZ, an array has the wrong shape or holds no numbers, or
            arrays have unequal lengths.
    """
    check_npz_file(path)
    with refusing_corrupt_npz(path), np.load(path, allow_pickle=False) as file:
        return _read_arrays(printable_path(path), file, column_map)


def _read_arrays(source: str, file: np.lib.npyio.NpzFile, column_map: ColumnMap) -> LogTable:
    if not file.files:
        raise Error(f"{source}: got no arrays, expected one per column")
    names = [name for name in file.files if not name.startswith((REPLAY_PREFIX, RUN_PREFIX))]
    column_map.check_names(source, names)
    components: ColumnComponents[Array] = ColumnComponents(source, column_map)
    lengths: dict[int, str] = {}
    notes = []
    for name in names:
        whole = None if column_map.find(name) else find_whole(name.strip().lower())
        if whole is not None and not column_map.has(COLUMN_BY_NAME[whole.column]):
            column, index, order = COLUMN_BY_NAME[whole.column], None, whole.order
            notes += [f"column '{name}' {whole.note}"] * bool(whole.note)
        else:
            found = components.find(name)
            if found is None:
                continue
            column, index, order = *found, None
        values = _column_array(source, name, file[name], column, index)
        values = values if order is None else values[:, order]
        lengths.setdefault(len(values), name)
        for k in range(values.shape[1]):
            components.add(name, column, k if index is None else index, values[:, k])
    places = components.ordered()
    if len(lengths) > 1:
        got = ", ".join(f"{name} {length}" for length, name in lengths.items())
        raise Error(f"{source}: got columns of unequal length ({got} rows), expected equal lengths")
    if 0 in lengths:
        raise Error(f"{source}: got columns without rows, expected one row per LowState")
    columns = {name: np.stack(parts, axis=1) for name, parts in places.items()}
    return LogTable(columns, components.ignored, notes, time_unit=components.time_unit)


def _column_array(
    source: str, name: str, values: np.ndarray, column: Column, index: int | None
) -> Array:
    """Return an array of the file in shape (n, width), or (n, 1) if it holds one component.

    Raises:
        Error: The array has another shape, or holds no numbers.
    """
    width = column.width if index is None else 1
    if values.dtype.kind in "mM":  # dates and durations: read_clock() finds their unit
        missing = np.isnat(values)
        values = np.where(missing, np.nan, values.astype(f"{values.dtype.kind}8[ns]").astype(float))
    if values.dtype.kind not in "biuf":
        raise Error(f"{source}: column '{name}': got {values.dtype} values, expected numbers")
    shaped = values[:, None] if values.ndim == 1 and width == 1 else values
    if shaped.ndim != 2 or shaped.shape[1] != width:
        turned = "; is it transposed?" if shaped.ndim == 2 and shaped.shape[0] == width else ""
        raise Error(
            f"{source}: column '{name}': got shape {values.shape}, expected (rows, {width}){turned}"
        )
    return shaped.astype(np.float64)
