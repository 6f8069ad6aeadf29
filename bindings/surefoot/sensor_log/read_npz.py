"""Reader of NPZ logs: one array per column, or one per component."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from surefoot._core import Error
from surefoot.files.corrupt_npz import CORRUPT_NPZ
from surefoot.geometry.batch_rotations import Array
from surefoot.sensor_log.column_components import ColumnComponents
from surefoot.sensor_log.column_definitions import REPLAY_PREFIX, RUN_PREFIX, Column


def read_npz(path: Path) -> tuple[dict[str, Array], list[str]]:
    """Return the columns (n, width) by name, and the unknown names in the file.

    Raises:
        Error: The file is not a valid NPZ, an array has the wrong shape or holds no numbers, or
            arrays have unequal lengths.
    """
    try:
        with np.load(path, allow_pickle=False) as file:
            return _read_arrays(path, file)
    except CORRUPT_NPZ as problem:
        raise Error(
            f"{path}: got no valid NPZ file ({problem}), expected arrays of numbers"
        ) from None


def _read_arrays(path: Path, file: np.lib.npyio.NpzFile) -> tuple[dict[str, Array], list[str]]:
    if not file.files:
        raise Error(f"{path}: got no arrays, expected one per column")
    components: ColumnComponents[Array] = ColumnComponents(str(path))
    lengths: dict[int, str] = {}
    for name in (name for name in file.files if not name.startswith((REPLAY_PREFIX, RUN_PREFIX))):
        found = components.find(name)
        if found is None:
            continue
        column, index = found
        values = _column_array(path, name, file[name], column, index)
        lengths.setdefault(len(values), name)
        for k in range(values.shape[1]):
            components.add(name, column, k if index is None else index, values[:, k])
    places = components.ordered()
    if len(lengths) > 1:
        got = ", ".join(f"{name} {length}" for length, name in lengths.items())
        raise Error(f"{path}: got columns of unequal length ({got} rows), expected equal lengths")
    if 0 in lengths:
        raise Error(f"{path}: got columns without rows, expected one row per LowState")
    return {name: np.stack(parts, axis=1) for name, parts in places.items()}, components.ignored


def _column_array(
    path: Path, name: str, values: np.ndarray, column: Column, index: int | None
) -> Array:
    """Return an array of the file in shape (n, width), or (n, 1) if it holds one component.

    Raises:
        Error: The array has another shape, or holds no numbers.
    """
    width = column.width if index is None else 1
    if values.dtype.kind not in "biuf":
        raise Error(f"{path}: column '{name}': got {values.dtype} values, expected numbers")
    shaped = values[:, None] if values.ndim == 1 and width == 1 else values
    if shaped.ndim != 2 or shaped.shape[1] != width:
        turned = "; is it transposed?" if shaped.ndim == 2 and shaped.shape[0] == width else ""
        raise Error(
            f"{path}: column '{name}': got shape {values.shape}, expected (rows, {width}){turned}"
        )
    return shaped.astype(np.float64)
