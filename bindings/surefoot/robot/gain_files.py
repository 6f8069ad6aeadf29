"""Gains as a TOML file: read, checked, written back to the last digit."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from surefoot._core import Error, Gains, gain_table, get_gain, set_gain
from surefoot.files.atomic_write import write_text_atomically
from surefoot.robot.robot_toml import read_toml


def gain_values(gains: Gains) -> dict[str, float]:
    """Return every gain by name: plain data, for files and pipes."""
    return {info.name: get_gain(gains, info.name) for info in gain_table()}


def changed_gains(gains: Gains, own: Gains) -> dict[str, float]:
    """Return those gains by name that differ from a robot's own."""
    values = gain_values(own)
    return {name: value for name, value in gain_values(gains).items() if value != values[name]}


def gains_from_values(values: dict[str, float]) -> Gains:
    """Return the library's gains with values by name on top; raises Error."""
    gains = Gains()
    for name, value in values.items():
        set_gain(gains, name, value)
    gains.validate()
    return gains


def load_gains(path: str | Path, start: Gains | None = None) -> Gains:
    """Read gains from a TOML file with a ``[gains]`` table (or plain keys).

    A value is a number, or ``{ value = 60.0, unit = "1/s^2" }``, whose unit is checked.

    Args:
        path: The file.
        start: Gains that keep their value where the file is silent; library defaults if None.

    Raises:
        Error: A key that is no gain, a value that is no number or out of range, another unit.
    """
    table = read_toml(Path(path))
    gains = start.__copy__() if start is not None else Gains()
    rows = table["gains"] if set(table) == {"gains"} else table
    if not isinstance(rows, dict):
        raise Error(f"{path}: 'gains' is {rows!r}, expected a table of names and numbers")
    apply_gains(gains, rows, str(path))
    return gains


def save_gains(path: str | Path, gains: Gains, robot: str | None = None, comment: str = "") -> None:
    """Write all gains as a TOML file that load_gains() reads back to the same gains.

    The file is written whole or not at all: beside its place first, then moved there.

    Args:
        path: The file.
        gains: What to write.
        robot: Whose gains they are, for the reader.
        comment: Lines for the head of the file, where they come from for instance.

    Raises:
        Error: A gain out of range.
        OSError: The file could not be written.
    """
    gains.validate()
    write_text_atomically(Path(path), gains_text(gains, robot, comment))


def gains_text(gains: Gains, robot: str | None = None, comment: str = "") -> str:
    """Return what save_gains() writes: every gain under its group, unit and meaning beside it."""
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
    """Write rows of a TOML into gains; raises Error naming the source and the valid names."""
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
        # TOML's integers have no end; so long a one would bury what is expected.
        raise Error(f"gain '{name}': got a number too large, expected at most 1.8e308") from None
