"""Reader of an SRDF: the pairs of links that do not collide."""

from __future__ import annotations

import os
from pathlib import Path

from surefoot._core import Error
from surefoot.robot.robot_toml import suggest
from surefoot.robot.xml_file import read_xml


def read_disabled_collisions(path: Path, links: frozenset[str]) -> list[tuple[str, str]]:
    """Return the pairs of <disable_collisions>.

    Args:
        path: The SRDF.
        links: Names of the links of the URDF.

    Raises:
        Error: The file cannot be read, or names a link that the URDF does not have.
    """
    if not os.path.lexists(path):
        raise Error(
            f"SRDF not found: got '{path}', expected a file relative to the folder of the URDF or "
            "to one above it; correct robot.srdf in the TOML, or remove it"
        )
    pairs = []
    for entry in read_xml(path, "SRDF").iter("disable_collisions"):
        names = []
        for attribute in ("link1", "link2"):
            name = entry.get(attribute)
            if name is None or name not in links:
                raise Error(
                    f"SRDF '{path}': <disable_collisions {attribute}>: got {name!r}"
                    f"{suggest(name or '', links)}, expected a link of the URDF"
                )
            names.append(name)
        pairs.append((names[0], names[1]))
    return pairs
