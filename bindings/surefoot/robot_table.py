"""A robot's TOML, read strictly."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Iterable
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from surefoot._core import Error

_Check = Callable[[Any], bool]


def _number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _numbers(*sizes: int) -> _Check:
    return lambda value: (
        isinstance(value, list) and len(value) in sizes and all(map(_number, value))
    )


def _word(value: Any) -> bool:
    return isinstance(value, str)


def _words(size: int) -> _Check:
    def check(value: Any) -> bool:
        return isinstance(value, list) and len(value) == size and all(map(_word, value))

    return check


_LIMITS = (_numbers(2), "[lower, upper] in rad")
_MOTORS = (_numbers(3, 12), "3 numbers (hip, thigh, calf) or 12")
# What each key must be, and how to say so. The names of gains are the core's to check.
_KEYS: dict[str, dict[str, tuple[_Check, str]]] = {
    "robot": {
        "name": (_word, "a word"),
        "urdf": (_word, "a path"),
        "srdf": (_word, "a path"),
        "joints": (_words(12), "12 joint names, FR FL RR RL"),
        "standing": _MOTORS,
        "friction": (_number, "a number"),
    },
    "feet": {"frames": (_words(4), "4 frame names, FR FL RR RL"), "radius": (_number, "metres")},
    "imu": {
        "frame": (_word, "a frame name"),
        "position": (_numbers(3), "3 numbers in metres"),
        "quaternion": (_numbers(4), "4 numbers, w x y z"),
    },
    "limits": {
        "hip": _LIMITS,
        "thigh": _LIMITS,
        "calf": _LIMITS,
        "hip_inward": (_number, "a number in rad"),
    },
    "motors": {"armature": _MOTORS, "corner_fraction": (_number, "a number")},
    "simulation": {
        "joint_friction": _MOTORS,
        "joint_damping": _MOTORS,
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
    """Read a TOML file; raises Error."""
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as problem:
        raise Error(f"cannot read '{path}': {problem.strerror}") from None
    # What is no TOML, no UTF-8, or an integer of more digits than Python reads.
    except ValueError as problem:
        raise Error(f"'{path}' is not valid TOML: {problem}") from None


def read_table(path: str | Path) -> dict[str, Any]:
    """Read a robot's TOML and check it: every key is known and of its type; raises Error."""
    table = read_toml(Path(path))
    _check_table(table, str(path))
    return table


def _check_table(table: dict[str, Any], source: str) -> None:
    for section, rows in table.items():
        if section in _KEYS and not isinstance(rows, dict):
            raise Error(f"{source}: '{section}' is {rows!r}, expected a table [{section}]")
        if section not in _KEYS:
            raise Error(
                f"{source}: unknown section [{section}]{suggest(section, _KEYS)}; "
                f"valid sections: {', '.join(_KEYS)}"
            )
        if section == "gains":
            continue
        for key in rows:
            if key not in _KEYS[section]:
                raise Error(
                    f"{source}: unknown key '{section}.{key}'{suggest(key, _KEYS[section])}; "
                    f"valid keys: {', '.join(sorted(_KEYS[section]))}"
                )
            check, expected = _KEYS[section][key]
            if not check(rows[key]):
                raise Error(f"{source}: {section}.{key}: got {rows[key]!r}, expected {expected}")
    for section, keys in _REQUIRED.items():
        for key in sorted(keys):
            if key not in table.get(section, {}):
                raise Error(f"{source}: missing key '{section}.{key}'")


def suggest(wrong: str, valid: Iterable[str]) -> str:
    """Return " (did you mean 'x'?)" where a valid name is close, else ""."""
    close = get_close_matches(wrong, list(valid), n=1)
    return f" (did you mean '{close[0]}'?)" if close else ""
