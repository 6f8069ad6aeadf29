"""Tables of named columns in CSV and NPZ files."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from surefoot._core import Error
from surefoot.files.atomic_write import atomic_path

_DIGITS = {np.dtype(np.float32): "%.9g", np.dtype(np.float64): "%.17g"}  # formats without loss
_CHUNK = 4096  # rows converted to text at a time


def check_table_name(path: str | Path, what: str) -> Path:
    """Return the path of a table; raise Error unless it ends in .csv or .npz.

    `what` names the table in the message.
    """
    path = Path(path)
    if path.suffix.lower() not in (".csv", ".npz"):
        raise Error(f"{what}: got '{path}', expected a name ending in .csv or .npz")
    return path


def write_table(path: Path, table: Mapping[str, np.ndarray]) -> None:
    """Write arrays (n,) or (n, k) as NPZ if the name ends in .npz, else as CSV.

    Raises:
        OSError: The file cannot be written.
    """
    if path.suffix.lower() == ".npz":
        write_npz(path, table)
    else:
        write_csv(path, table)


def write_npz(path: Path, table: Mapping[str, np.ndarray]) -> None:
    """Write arrays (n,) or (n, k) as NPZ under their names.

    Raises:
        OSError: The file cannot be written.
    """
    # Pass an open file, because numpy would append .npz to a path that ends in .NPZ.
    with atomic_path(path) as place, place.open("wb") as file:
        np.savez_compressed(file, allow_pickle=False, **table)


def write_csv(path: Path, table: Mapping[str, np.ndarray]) -> None:
    """Write a header and one line per row; arrays (n, k) become columns name_0, name_1 ...

    Raises:
        OSError: The file could not be written.
    """
    header, formats, columns = [], [], []
    for name, values in table.items():
        parts = values[:, None] if values.ndim == 1 else values
        width = parts.shape[1]
        header += [name] if values.ndim == 1 else [f"{name}_{k}" for k in range(width)]
        formats += [_DIGITS.get(values.dtype, "%s" if values.dtype.kind == "U" else "%d")] * width
        columns += [parts[:, k] for k in range(width)]
    line = ",".join(formats)
    with atomic_path(path) as place, place.open("w", encoding="utf-8", newline="\n") as file:
        file.write(",".join(header) + "\n")
        for start in range(0, len(columns[0]), _CHUNK):
            block = (column[start : start + _CHUNK].tolist() for column in columns)
            file.writelines(line % row + "\n" for row in zip(*block, strict=True))
