"""Reads scorecard files, of standing and of walking."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from pathlib import Path
from typing import Any, TypeVar

from surefoot._core import Error
from surefoot.assess.condition import read_condition
from surefoot.robot.robot_toml import read_toml, suggest

Card = TypeVar("Card")


def read_scorecard_file(
    card_type: Callable[..., Card],
    path: str | Path,
    name: str | None,
    tuples: Callable[[dict[str, Any]], None],
) -> Card:
    """Read a scorecard from a TOML file.

    Args:
        card_type: Scorecard or WalkScorecard.
        path: Path of the file.
        name: Name of the scorecard; None: the file name without its extension.
        tuples: Function that turns lists of the file into the tuples of the fields, in place.

    Raises:
        Error: The file cannot be read, is not valid TOML, or has an unknown key or invalid value.
    """
    table = read_toml(Path(path))
    try:
        values = _values(card_type, table)
        tuples(values)
        return card_type(name=name or Path(path).stem, **values)
    except (Error, TypeError) as problem:
        raise Error(f"scorecard file '{path}': {problem}") from None


def _values(card_type: Callable[..., Any], table: dict[str, Any]) -> dict[str, Any]:
    names = [f.name for f in fields(card_type)]  # type: ignore[arg-type]
    valid = [name for name in names if name not in ("name", "conditions")] + ["condition"]
    for key in table:
        if key not in valid:
            hint = suggest(key, valid)
            raise Error(f"unknown key '{key}'{hint}; valid names: {', '.join(valid)}")
    values = {key: value for key, value in table.items() if key != "condition"}
    tables = table.get("condition", [])
    if not isinstance(tables, list):
        raise Error(f"condition: got {tables!r}, expected tables [[condition]]")
    if tables:
        values["conditions"] = tuple(read_condition(entry) for entry in tables)
    return values
