# SPDX-License-Identifier: BSD-3-Clause
"""Edited copies of a known robot's files, for tests of what a user hands over."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Callable
from pathlib import Path

import surefoot
from surefoot.robot.loading import describe_robot

MODELS = Path(surefoot.__file__).parent / "models"
Edit = Callable[[ET.Element], None]


class EditedRobot:
    """Writes go1's URDF with edits, and its TOML with replaced text, into a folder."""

    def __init__(self, folder: Path, name: str = "go1") -> None:
        self.folder, self.description = folder, describe_robot(name)
        self.toml = (MODELS / f"{name}.toml").read_text(encoding="utf-8")

    def write(self, *edits: Edit, toml: tuple[str, str] = ("", "")) -> dict[str, Path]:
        """Return urdf= and config= of the edited robot."""
        text = self.description.urdf.read_text(encoding="utf-8")
        root = ET.fromstring(
            text.replace("package://example-robot-data", str(self.description.mesh_root))
        )
        for edit in edits:
            edit(root)
        urdf, config = self.folder / "my.urdf", self.folder / "my.toml"
        ET.ElementTree(root).write(urdf, encoding="utf-8")
        assert toml[0] in self.toml
        own = self.toml.replace(*toml) if toml[0] else self.toml
        config.write_text(own.replace('srdf = "', f'srdf = "{self.description.mesh_root}/robots/'))
        return {"urdf": urdf, "config": config}

    def load(self, *edits: Edit, toml: tuple[str, str] = ("", "")) -> surefoot.Robot:
        return surefoot.load_robot(**self.write(*edits, toml=toml))


def put(path: str, **attributes: str) -> Edit:
    """Return an edit that sets attributes of the element at an ElementTree path."""

    def edit(root: ET.Element) -> None:
        element = root.find(path)
        assert element is not None, path
        element.attrib.update(attributes)

    return edit


def retag(path: str, tag: str) -> Edit:
    """Return an edit that renames the element at a path."""

    def edit(root: ET.Element) -> None:
        element = root.find(path)
        assert element is not None, path
        element.tag = tag

    return edit


def drop(path: str) -> Edit:
    """Return an edit that removes the element at a path."""

    def edit(root: ET.Element) -> None:
        element = root.find(path)
        assert element is not None, path
        next(parent for parent in root.iter() if element in list(parent)).remove(element)

    return edit


def add(path: str, xml: str) -> Edit:
    """Return an edit that appends an element to the one at a path."""

    def edit(root: ET.Element) -> None:
        element = root.find(path) if path != "." else root
        assert element is not None, path
        element.extend(ET.fromstring(f"<all>{xml}</all>"))

    return edit


def link(name: str, inside: str = "") -> str:
    return f"link[@name='{name}']{inside}"


def joint(name: str, inside: str = "") -> str:
    return f"joint[@name='{name}']{inside}"


def put_inertia(name: str, **values: str) -> Edit:
    return put(link(name, "/inertial/inertia"), **values)
