"""Map from the columns of a log to the names in a file, as `--columns FILE` gives it."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path
from typing import Any

from surefoot._core import Error
from surefoot.robot.robot_toml import read_toml, suggest
from surefoot.sensor_log.column_definitions import COLUMN_BY_NAME, Column, valid_names
from surefoot.sensor_log.column_names import find_column
from surefoot.sensor_log.file_checks import check_log_file, printable_path


class ColumnMap:
    """Names in a file, and the columns that they hold.

    Args:
        names: For each name in the file: the column, and the component, or None for all of them.
        source: Name of the map's file, for messages.

    A column in the map is read from the names in the map alone.

    Attributes:
        names: See above.
    """

    def __init__(
        self, names: dict[str, tuple[Column, int | None]] | None = None, source: str = ""
    ) -> None:
        self.names = names or {}
        self._source = source
        self._columns = {column.name for column, _ in self.names.values()}

    def find(self, text: str) -> tuple[Column, int | None] | None:
        """Return the column and component that the map gives a name, or None."""
        return self.names.get(text.strip())

    def has(self, column: Column) -> bool:
        """Return whether the map names the source of a column."""
        return column.name in self._columns

    def check_names(self, source: str, present: Collection[str]) -> None:
        """Raise Error unless the log has every name of the map.

        Args:
            source: Name of the log, for messages.
            present: Names in the log.
        """
        found = {name.strip() for name in present}
        for name, (column, index) in self.names.items():
            if name not in found:
                ours = column.name if index is None else column.component(index)
                raise Error(
                    f"{self._source}: {ours}: got '{name}', expected a name in {source}"
                    f"{suggest(name, found)}"
                )


def read_column_map(path: str | Path) -> ColumnMap:
    """Read a map of column names from a TOML file.

    Each key is a column or a component, each value the name in the log, or the list of the names
    of a column's components: ``gyroscope = ["wx", "wy", "wz"]``.

    Raises:
        Error: The file cannot be read, a key is unknown, or a value is no name.
    """
    path = Path(path)
    check_log_file(path)
    source = printable_path(path)
    names: dict[str, tuple[Column, int | None]] = {}
    for key, value in read_toml(path).items():
        column, index = _column_of_key(source, key)
        for place, name in _names_of_value(source, key, value, column, index):
            if name in names:
                raise Error(f"{source}: {key}: got '{name}' for two columns, expected it once")
            names[name] = (column, place)
    return ColumnMap(names, source)


def _column_of_key(source: str, key: str) -> tuple[Column, int | None]:
    found = (COLUMN_BY_NAME[key], None) if key in COLUMN_BY_NAME else find_column(key)
    if found is None:
        raise Error(
            f"{source}: got the unknown column '{key}'{suggest(key, COLUMN_BY_NAME)}, expected "
            f"one of (with width): {valid_names()}"
        )
    return found


def _names_of_value(
    source: str, key: str, value: Any, column: Column, index: int | None
) -> list[tuple[int | None, str]]:
    """Return component and name in the log for each name of one entry."""
    if isinstance(value, str) and value.strip():
        return [(index, value.strip())]
    width = column.width if index is None else 1
    is_list = isinstance(value, list) and all(isinstance(name, str) and name for name in value)
    if not is_list or width == 1 or len(value) != width:
        expected = "a name" if width == 1 else f"a name or a list of {width} names"
        raise Error(f"{source}: {key}: got {value!r}, expected {expected} in quotes")
    return [(place, name.strip()) for place, name in enumerate(value)]
