"""Gait, from its name in an argument or in a typed line."""

from __future__ import annotations

from surefoot._core import Error, Gait
from surefoot.robot.robot_toml import suggest


def read_gait(what: str, text: str) -> Gait:
    """Return the Gait that a name means.

    Args:
        what: Option or key that the name belongs to, for the message of the error.
        text: Name in lower case.

    Raises:
        Error: The name is unknown.
    """
    names = {gait.name.lower(): gait for gait in Gait}
    if text not in names:
        valid = ", ".join(names)
        raise Error(f"{what}: got '{text}'{suggest(text, names)}; valid names: {valid}")
    return names[text]
