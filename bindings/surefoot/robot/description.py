"""Find and check the files that describe a robot, by the robot's name or by their paths."""

from __future__ import annotations

import importlib.metadata
import os
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from surefoot._core import Error
from surefoot.robot.robot_toml import read_table, suggest


@dataclass(frozen=True)
class RobotDescription:
    """Files and parsed TOML from which a robot is built.

    Attributes:
        name: Name of the robot, one word.
        urdf: Path of the URDF.
        srdf: Path of the SRDF, or None.
        mesh_root: Folder that replaces ``package://example-robot-data/`` in the URDF.
        table: The robot's TOML, as returned by read_table().
        mjcf: MJCF file from which the simulated robot is built; None: it is built from the URDF.
            The controller's robot always comes from the URDF.
    """

    name: str
    urdf: Path
    srdf: Path | None
    mesh_root: Path
    table: dict[str, Any]
    mjcf: Path | None = None

    def with_mjcf(self, mjcf: str | Path) -> RobotDescription:
        """Return this description with another simulated robot: that of an MJCF file."""
        return replace(self, mjcf=Path(mjcf))


# Robots of which the package has the TOML only, because example-robot-data has no URDF of them.
_WITHOUT_URDF = ("aliengo", "b2")


def available_robots() -> list[str]:
    """Return the names of the robots that load_robot() can load by name."""
    names = {path.stem for path in _models_folder().glob("*.toml")}
    return sorted(names - set(_WITHOUT_URDF))


def robots_without_urdf() -> list[str]:
    """Return the names of the robots that load_robot() loads by name and urdf=."""
    return list(_WITHOUT_URDF)


def settings_file(name: str) -> Path:
    """Return the TOML that the package has for a robot: one of the names of the functions above."""
    return _models_folder() / f"{name}.toml"


def describe_robot(
    name: str | None = None, *, urdf: str | Path | None = None, config: str | Path | None = None
) -> RobotDescription:
    """Find a robot's files and check its TOML, without building the model.

    The robot is given either by `name`, or by `urdf` and `config`, or by `name` and `urdf` if the
    name is one of robots_without_urdf().

    Args:
        name: One of available_robots() or of robots_without_urdf().
        urdf: Path of the URDF.
        config: Path of the robot's TOML.

    Raises:
        Error: Neither a name nor both files are given, or a name and files are given; or a file
            is missing or invalid.
    """
    if name in _WITHOUT_URDF:
        return _describe_with_urdf(name, urdf, config)
    if name is not None and (urdf is not None or config is not None):
        raise Error(f"robot: got name '{name}' and files, expected a name, or urdf= and config=")
    if name is not None:
        return _describe_by_name(name)
    if urdf is None or config is None:
        raise Error("robot: got too little, expected a name, or both urdf= and config=")
    return _describe_files(read_table(config), Path(urdf))


def _describe_files(table: dict[str, Any], path: Path) -> RobotDescription:
    if not os.path.lexists(path):
        raise Error(f"URDF not found: got '{path}', expected a file")
    # MuJoCo finds meshes by an absolute path only.
    path = path.absolute()
    srdf = table["robot"].get("srdf")
    return RobotDescription(
        table["robot"]["name"], path, _find_srdf(srdf, path) if srdf else None, path.parent, table
    )


def _find_srdf(name: str, urdf: Path) -> Path:
    """Return the SRDF, relative to the folder of the URDF or to a folder above it."""
    for folder in urdf.parents:
        if os.path.lexists(folder / name):
            return folder / name
    return urdf.parent / name


def _describe_with_urdf(
    name: str, urdf: str | Path | None, config: str | Path | None
) -> RobotDescription:
    if urdf is None or config is not None:
        got = "no URDF" if urdf is None else "config="
        raise Error(
            f"robot '{name}': got {got}, expected the name and urdf= (--urdf), because "
            f"example-robot-data has no URDF of it; take robots/{name}_description/urdf/"
            f"{name}_description.urdf of github.com/unitreerobotics/unitree_ros"
        )
    return _describe_files(read_table(settings_file(name)), Path(urdf))


def _describe_by_name(name: str) -> RobotDescription:
    if name not in available_robots():
        raise Error(
            f"unknown robot: got '{name}'{suggest(name, available_robots())}; "
            f"valid names: {', '.join(available_robots())}"
        )
    table = read_table(settings_file(name))
    root = _robot_data_folder()
    robot = table["robot"]
    return RobotDescription(
        name, root / "robots" / robot["urdf"], root / "robots" / robot["srdf"], root, table
    )


def _models_folder() -> Path:
    return Path(__file__).parents[1] / "models"


def _robot_data_folder() -> Path:
    """Return the folder share/example-robot-data of the package example-robot-data.

    The function searches the package's file list, because its wheel has no Python module.

    Raises:
        Error: The package is not installed, or has no such folder.
    """
    try:
        files = importlib.metadata.files("example-robot-data") or []
    except importlib.metadata.PackageNotFoundError:
        raise Error(
            "robot data not found: loading a robot by name needs the example-robot-data package; "
            "run: pip install 'surefoot[sim]' (or use a URDF, or a .robot file)"
        ) from None
    marker = "share/example-robot-data/robots/"
    for file in files:
        text = str(file)
        if marker in text:
            start = text.index(marker) + len(marker) - len("robots/")
            return Path(str(file.locate())[: len(str(file.locate())) - len(text) + start])
    raise Error(
        "robot data: the example-robot-data package has no share/example-robot-data/robots; "
        "install it again, version 6"
    )
