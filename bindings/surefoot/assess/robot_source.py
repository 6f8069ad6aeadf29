"""Sources of a robot that can be pickled: by name, by files, or with an MJCF."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from pathlib import Path

import mujoco
import numpy as np

from surefoot.robot.description import RobotDescription, describe_robot
from surefoot.sim.mjcf.file import read_mjcf


@dataclass(frozen=True)
class MjcfSource:
    """A robot whose plant is built from an MJCF.

    Attributes:
        robot: The controller's robot: a name, or the paths of its URDF and TOML.
        mjcf: Path of the MJCF.
    """

    robot: str | tuple[str, str]
    mjcf: str


RobotSource = str | tuple[str, str] | MjcfSource
"""A robot's name, the paths of its URDF and TOML, or one of these with an MJCF."""


def describe_source(source: RobotSource) -> RobotDescription:
    """Return the description of a robot.

    Raises:
        Error: The robot is unknown, or its files are missing or invalid.
    """
    if isinstance(source, MjcfSource):
        return describe_source(source.robot).with_mjcf(source.mjcf)
    if isinstance(source, str):
        return describe_robot(source)
    return describe_robot(urdf=source[0], config=source[1])


def mjcf_digest(mjcf: str) -> str:
    """Return a digest of the compiled model, with includes and meshes: 16 hexadecimal digits."""
    _, model = read_mjcf(Path(mjcf))
    data = np.zeros(mujoco.mj_sizeModel(model), np.uint8)
    mujoco.mj_saveModel(model, None, data)
    return hashlib.sha256(data.tobytes()).hexdigest()[:16]
