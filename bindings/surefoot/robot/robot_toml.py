"""Reader of a robot's TOML, which rejects unknown keys and wrong types."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Iterable
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from surefoot._core import Error

_Check = Callable[[Any], bool]


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _is_number_list(*sizes: int) -> _Check:
    return lambda value: (
        isinstance(value, list) and len(value) in sizes and all(map(_is_number, value))
    )


def _is_string(value: Any) -> bool:
    return isinstance(value, str)


def _is_string_list(size: int) -> _Check:
    def check(value: Any) -> bool:
        return isinstance(value, list) and len(value) == size and all(map(_is_string, value))

    return check


_LIMIT_PAIR = (_is_number_list(2), "[lower, upper] in rad")
_PER_MOTOR = (_is_number_list(3, 12), "3 numbers (hip, thigh, calf) or 12")
# Sections and keys of the TOML, each key with its check and the expected value in words. The keys
# of [gains] are checked by the C++ core.
_SCHEMA: dict[str, dict[str, tuple[_Check, str]]] = {
    "robot": {
        "name": (_is_string, "a word"),
        "urdf": (_is_string, "a path"),
        "srdf": (_is_string, "a path"),
        "joints": (_is_string_list(12), "12 joint names, FR FL RR RL"),
        "standing": _PER_MOTOR,
        "friction": (_is_number, "a number"),
    },
    "feet": {
        "frames": (_is_string_list(4), "4 frame names, FR FL RR RL"),
        "radius": (_is_number, "metres"),
    },
    "imu": {
        "frame": (_is_string, "a frame name"),
        "position": (_is_number_list(3), "3 numbers in metres"),
        "quaternion": (_is_number_list(4), "4 numbers, w x y z"),
    },
    "limits": {
        "hip": _LIMIT_PAIR,
        "thigh": _LIMIT_PAIR,
        "calf": _LIMIT_PAIR,
        "hip_inward": (_is_number, "a number in rad"),
    },
    "motors": {"armature": _PER_MOTOR, "corner_fraction": (_is_number, "a number")},
    "simulation": {
        "joint_friction": _PER_MOTOR,
        "joint_damping": _PER_MOTOR,
        "foot_force_est": (lambda value: isinstance(value, bool), "true or false"),
    },
    "gains": {},
}
_REQUIRED = {
    "robot": {"name", "joints", "standing"},
    "feet": {"frames", "radius"},
    "motors": {"armature", "corner_fraction"},
}


def read_toml(path: Path) -> dict[str, Any]:
    """Read a TOML file.

    Raises:
        Error: The file cannot be read, or is not valid TOML.
    """
    try:
        return tomllib.loads(path.read_text(encoding="utf-8-sig"))  # editors may write a BOM
    except OSError as problem:
        raise Error(f"cannot read '{path}': {problem.strerror}") from None
    # ValueError covers invalid TOML, invalid UTF-8 and integers too long for Python.
    except ValueError as problem:
        raise Error(f"'{path}' is not valid TOML: {problem}") from None


def read_table(path: str | Path) -> dict[str, Any]:
    """Read a robot's TOML and check its keys and types.

    Returns:
        The TOML as nested dicts: section, key, value.

    Raises:
        Error: The file is not valid TOML, a key is unknown or missing, or a value has the wrong
            type.
    """
    table = read_toml(Path(path))
    _check_table(table, str(path))
    return table


def _check_table(table: dict[str, Any], source: str) -> None:
    for section, rows in table.items():
        if section in _SCHEMA and not isinstance(rows, dict):
            raise Error(f"{source}: {section}: got {rows!r}, expected a table [{section}]")
        if section not in _SCHEMA:
            raise Error(
                f"{source}: unknown section [{section}]{suggest(section, _SCHEMA)}; "
                f"valid sections: {', '.join(_SCHEMA)}"
            )
        if section == "gains":
            continue
        for key in rows:
            if key not in _SCHEMA[section]:
                raise Error(
                    f"{source}: unknown key '{section}.{key}'{suggest(key, _SCHEMA[section])}; "
                    f"valid keys: {', '.join(sorted(_SCHEMA[section]))}"
                )
            check, expected = _SCHEMA[section][key]
            if not check(rows[key]):
                raise Error(f"{source}: {section}.{key}: got {rows[key]!r}, expected {expected}")
    for section, keys in _REQUIRED.items():
        for key in sorted(keys):
            if key not in table.get(section, {}):
                raise Error(
                    f"{source}: missing key '{section}.{key}'; expected as in models/go1.toml"
                )


def suggest(wrong: str, valid: Iterable[str]) -> str:
    """Return " (did you mean 'x'?)" with the nearest valid name, or "" if none is near."""
    close = get_close_matches(wrong, list(valid), n=1)
    return f" (did you mean '{close[0]}'?)" if close else ""
