"""Joints of a sensor_msgs/JointState in a CSV file, whose order the columns name[0] .. give."""

from __future__ import annotations

from collections.abc import Iterator

from surefoot._core import Error
from surefoot.sensor_log.csv_lines import CsvLines
from surefoot.sensor_log.foreign_names import joint_array, motor_of_joint


class JointArrays:
    """Collector of the columns of JointStates in a header.

    Args:
        lines: The file.
    """

    def __init__(self, lines: CsvLines) -> None:
        self._lines = lines
        # Prefixes of arrays that have names, for example "field.".
        arrays = [joint_array(name) for name in lines.header]
        self._named = {found[0] for found in arrays if found is not None and found[1] == "name"}
        self._places: dict[tuple[str, int], dict[str, int]] = {}

    def add(self, name: str, place: int) -> bool:
        """Record a column; return whether it belongs to a JointState with names."""
        found = joint_array(name)
        if found is None or found[0] not in self._named:
            return False
        self._places.setdefault((found[0], found[2]), {})[found[1]] = place
        return True

    def found(self) -> Iterator[tuple[str, str, int, int]]:
        """Yield name, column, motor and place of each column of a leg's joint.

        Raises:
            Error: The name of a joint changes in the file.
        """
        for fields in self._places.values():
            motor = self._motor(fields["name"]) if "name" in fields else None
            if motor is None:
                continue
            for column, place in fields.items():
                if column != "name":
                    yield self._lines.header[place], column, motor, place

    def _motor(self, place: int) -> int | None:
        lines = self._lines
        first = None
        for row in range(len(lines.rows)):
            cells = lines.cells(row)
            if place >= len(cells):
                continue  # a short row: read_numbers() refuses it, or leaves out the last line
            if first is None:
                first = cells[place]
            elif cells[place] != first:
                raise Error(
                    f"{lines.source}: line {lines.numbers[row]}, column '{lines.header[place]}': "
                    f"got '{cells[place]}', expected '{first}' as in line {lines.numbers[0]}"
                )
        return None if first is None else motor_of_joint(first)
