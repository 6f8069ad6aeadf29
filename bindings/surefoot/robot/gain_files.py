"""Gains as TOML files, read with checks and written without loss of digits."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from surefoot._core import Error, Gains, gain_table, get_gain, set_gain
from surefoot.files.atomic_write import write_text_atomically
from surefoot.robot.robot_toml import read_toml


def gain_values(gains: Gains) -> dict[str, float]:
    """Return the value of every gain by name, for files and pipes."""
    return {info.name: get_gain(gains, info.name) for info in gain_table()}


def changed_gains(gains: Gains, own: Gains) -> dict[str, float]:
    """Return those values of `gains`, by name, that differ from `own`, the robot's own gains."""
    values = gain_values(own)
    return {name: value for name, value in gain_values(gains).items() if value != values[name]}


def gains_from_values(values: dict[str, float]) -> Gains:
    """Return the library's default gains, changed to `values` (gain name to value).

    Raises:
        Error: Unknown gain, or value out of range.
    """
    gains = Gains()
    for name, value in values.items():
        set_gain(gains, name, value)
    gains.validate()
    return gains


def load_gains(path: str | Path, start: Gains | None = None) -> Gains:
    """Read gains from a TOML file with a ``[gains]`` table (or plain keys).

    A value is a number, or a table ``{ value = 60.0, unit = "1/s^2" }`` with a unit to check.

    Args:
        path: The file.
        start: Gains that the result has where the file names no value. None: the library's
            defaults. `start` itself is not changed.

    Raises:
        Error: Unknown gain, value not a number or out of range, or wrong unit.
    """
    table = read_toml(Path(path))
    gains = start.__copy__() if start is not None else Gains()
    rows = table["gains"] if set(table) == {"gains"} else table
    if not isinstance(rows, dict):
        raise Error(f"{path}: gains: got {rows!r}, expected a table of names and numbers")
    apply_gains(gains, rows, str(path))
    return gains


def save_gains(path: str | Path, gains: Gains, robot: str | None = None, comment: str = "") -> None:
    """Write all gains to a TOML file; load_gains() reads exactly the same values.

    The write is atomic.

    Args:
        path: The file.
        gains: Gains to write.
        robot: Name of the robot, for the header.
        comment: Further lines of the header, for example the origin of the gains.

    Raises:
        Error: A gain is out of range.
        OSError: The file could not be written.
    """
    gains.validate()
    write_text_atomically(Path(path), gains_text(gains, robot, comment))


def gains_text(gains: Gains, robot: str | None = None, comment: str = "") -> str:
    """Return the text that save_gains() writes: all gains by group, with unit and meaning."""
    header = [f"Gains of {robot}." if robot else "Gains.", *comment.splitlines()]
    lines = [f"# {line}".rstrip() for line in header] + ["", "[gains]"]
    group = ""
    for info in gain_table():
        if info.group != group:
            group = info.group
            lines += ["", f"# {group}"]
        entry = f"{info.name} = {get_gain(gains, info.name)!r}"
        lines.append(f"{entry:<40} # [{info.unit}] {info.meaning}")
    return "\n".join(lines) + "\n"


def apply_gains(gains: Gains, rows: dict[str, Any], source: str) -> None:
    """Set gains from rows of a TOML file.

    Args:
        gains: Gains to change.
        rows: Values by name.
        source: Name of the file, for messages.

    Raises:
        Error: Unknown gain, value not a number or out of range, or wrong unit.
    """
    for name, value in rows.items():
        try:
            set_gain(gains, name, _number(name, value))
        except Error as problem:
            raise Error(f"{source}: {problem}") from None
    gains.validate()


def _number(name: str, value: Any) -> float:
    if isinstance(value, dict):
        unit = {info.name: info.unit for info in gain_table()}.get(name)
        if set(value) != {"value", "unit"}:
            got = ", ".join(sorted(map(str, value))) or "nothing"
            raise Error(f"gain '{name}': got a table of {got}, expected value and unit")
        if unit is not None and value["unit"] != unit:
            raise Error(f"gain '{name}': got unit {value['unit']!r}, expected '{unit}'")
        value = value["value"]
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise Error(f"gain '{name}': got {value!r}, expected a number")
    try:
        return float(value)
    except OverflowError:
        # A TOML integer can have thousands of digits, so the message omits the value.
        raise Error(f"gain '{name}': got a number too large, expected at most 1.8e308") from None
