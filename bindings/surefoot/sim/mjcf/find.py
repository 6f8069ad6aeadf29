"""Finds all parts of a robot in an MJCF file."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import mujoco

from surefoot._core import Error, Robot
from surefoot.sim.mjcf.conventions import JointConvention, joint_conventions
from surefoot.sim.mjcf.feet import Foot, find_feet
from surefoot.sim.mjcf.file import read_mjcf
from surefoot.sim.mjcf.ground import Ground, find_ground
from surefoot.sim.mjcf.imu_mount import ImuMount, find_imu
from surefoot.sim.mjcf.tree import Tree, find_tree


@dataclass(frozen=True)
class MjcfParts:
    """All parts of a robot in an MJCF file.

    Attributes:
        spec: The file's specification; its elements have the ids of `model`.
        model: The specification, compiled.
        tree: Base and legs.
        feet: Feet FR FL RR RL.
        imu: Mount of the IMU.
        ground: Ground.
        conventions: Signs and zeros of the twelve joints, SDK order.
    """

    spec: mujoco.MjSpec
    model: mujoco.MjModel
    tree: Tree
    feet: tuple[Foot, ...]
    imu: ImuMount
    ground: Ground
    conventions: list[JointConvention]


def find_parts(path: Path, robot: Robot) -> MjcfParts:
    """Read an MJCF file and find base, legs, feet, IMU and ground in it.

    Args:
        path: The file.
        robot: The controller's robot, for its joint conventions and its IMU mount.

    Raises:
        Error: The file is invalid, or a part is missing or not supported; the message names it.
    """
    spec, model = read_mjcf(path)
    try:
        tree, ground = find_tree(model), find_ground(model)
        feet = find_feet(model, tree, ground)
        conventions = joint_conventions(model, tree, feet, robot)
        return MjcfParts(spec, model, tree, feet, find_imu(model, tree, robot), ground, conventions)
    except Error as problem:
        raise Error(f"MJCF '{path}': {problem}") from None
