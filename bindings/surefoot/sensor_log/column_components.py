"""Location of each column's components in a file; every component must be present exactly once."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches
from typing import Generic, TypeVar

from surefoot._core import Error
from surefoot.sensor_log.column_definitions import (
    CLOCK_COLUMNS,
    COLUMNS,
    REQUIRED_COLUMNS,
    Column,
    valid_names,
)
from surefoot.sensor_log.column_map import ColumnMap
from surefoot.sensor_log.column_names import find_column
from surefoot.sensor_log.foreign_names import clock_rank, clock_unit

Location = TypeVar("Location")


class ColumnComponents(Generic[Location]):
    """Collector of the locations at which a file holds the components of each column.

    A reader calls find() for each name in the file, add() for each component, and ordered() at the
    end. The reader chooses the type of a location, for example the index of a CSV column.

    Args:
        source: Name of the file, for messages.
        column_map: Names that the user gives to columns.

    Attributes:
        ignored: Unknown names in the file, in the order of the file.
        nanoseconds: Location of the nanoseconds of a ROS stamp, whose seconds are `time`.
    """

    def __init__(self, source: str, column_map: ColumnMap) -> None:
        self.ignored: list[str] = []
        self.nanoseconds: Location | None = None
        self._map = column_map
        self._source = source
        self._locations: dict[tuple[str, int], tuple[str, Location]] = {}

    def find(self, text: str) -> tuple[Column, int | None] | None:
        """Return column and component of a name, by the map or else by find_column().

        An unknown name is added to `ignored`.
        """
        found = self._map.find(text)
        if found is None:
            found = find_column(text)
            found = None if found is None or self._map.has(found[0]) else found
        if found is None:
            self.ignored.append(text)
        return found

    def add(self, text: str, column: Column, index: int, location: Location) -> None:
        """Record the location of a component that the file holds under the name `text`.

        A file may have several clocks in seconds: the sensors' own stamp is used.

        Raises:
            Error: The component has a location already.
        """
        name = column.component(index)
        if (column.name, index) in self._locations:
            first = self._locations[column.name, index][0]
            if column.name == "time" and _rank(text) != _rank(first):
                self.ignored.append(max(first, text, key=_rank))
                if _rank(text) < _rank(first):
                    self._locations[column.name, index] = (text, location)
                return
            raise Error(
                f"{self._source}: column '{name}': got '{first}' and '{text}', expected it once"
            )
        self._locations[column.name, index] = (text, location)

    @property
    def time_unit(self) -> str | None:
        """Unit that the name of the column `time` states; None if it states none."""
        text = self._locations["time", 0][0] if ("time", 0) in self._locations else ""
        return clock_unit(text.strip().lower())

    def ordered(self) -> dict[str, list[Location]]:
        """Return the locations of the components of each column, in component order.

        Raises:
            Error: A column lacks some of its components, or a required column is missing.
        """
        complete = {}
        for column in COLUMNS:
            got = [k for k in range(column.width) if (column.name, k) in self._locations]
            if 0 < len(got) < column.width:
                raise Error(
                    f"{self._source}: column '{column.name}': got {len(got)} of its components "
                    f"({', '.join(column.component(k) for k in got)}), expected {column.width}: "
                    f"{column.component(0)} .. {column.component(column.width - 1)}"
                )
            if got:
                complete[column.name] = [self._locations[column.name, k][1] for k in got]
        self._check_required(complete)
        return complete

    def _check_required(self, names: Iterable[str]) -> None:
        present = set(names)
        missing = [name for name in REQUIRED_COLUMNS if name not in present]
        if missing or not present & set(CLOCK_COLUMNS):
            name = missing[0] if missing else "tick"
            other = " (or 'time')" if name == "tick" else ""
            # The column may be in the file under a misspelt name: suggest the nearest unknown name.
            close = get_close_matches(
                name, [text.rstrip("_0123456789[].") for text in self.ignored]
            )
            hint = next((t for t in self.ignored if close and t.startswith(close[0])), None)
            meant = f" (is it '{hint}'?)" if hint else ""
            got = ", ".join([*sorted(present), *(f"'{text}'" for text in self.ignored)])
            raise Error(
                f"{self._source}: missing column '{name}'{other}{meant}: got {got or 'none'}, "
                f"expected a clock, {', '.join(REQUIRED_COLUMNS)}; "
                f"valid names (and widths): {valid_names()}"
            )


def _rank(text: str) -> int:
    """Return the rank of a clock's name, 0 the best; the seconds of a ROS stamp are the best."""
    rank = clock_rank(text.strip().lower())
    return 0 if rank is None else rank
