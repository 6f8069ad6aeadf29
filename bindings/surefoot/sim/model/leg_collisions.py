"""Collisions of the legs with each other and with the trunk.

An SRDF disables pairs of links whose shapes overlap, and often also pairs that a planner of arm
motions need not check. The legs of a walking robot may hit such a pair. So the plant can ignore the
SRDF and exclude only the pairs that overlap in the standing pose: their contacts would push the
links apart. MuJoCo itself ignores contacts between a link and its parent.
"""

from __future__ import annotations

import mujoco
import numpy as np
import numpy.typing as npt

from surefoot._core import Robot
from surefoot.messages.low_state_layout import LEGS

TRUNK = "trunk"


def exclude_overlapping_pairs(
    spec: mujoco.MjSpec, model: mujoco.MjModel, robot: Robot
) -> list[tuple[str, str]]:
    """Exclude the pairs of links that overlap in the standing pose, and return their names.

    Args:
        spec: Specification that receives the exclusions; compile it again afterwards.
        model: The compiled specification.
        robot: The robot, for its standing pose.
    """
    data = mujoco.MjData(model)
    for name, q in zip(robot.config.joint_names, robot.config.q_standing, strict=True):
        data.qpos[model.joint(name).qposadr[0]] = q
    mujoco.mj_fwdPosition(model, data)
    parts = part_of_geoms(model, robot)
    pairs = {
        (int(model.geom_bodyid[first]), int(model.geom_bodyid[second]))
        for first, second in data.contact.geom
        if parts[first] >= 0 and parts[second] >= 0
    }
    names = [(model.body(first).name, model.body(second).name) for first, second in sorted(pairs)]
    for first, second in names:
        spec.add_exclude(bodyname1=first, bodyname2=second)
    return names


def part_of_geoms(model: mujoco.MjModel, robot: Robot) -> npt.NDArray[np.int64]:
    """Return the part of the robot that each geom belongs to: leg 0 .. 3, 4 trunk, -1 none."""
    hips = [int(model.joint(robot.config.joint_names[3 * leg]).bodyid[0]) for leg in range(4)]
    base = int(model.body_rootid[hips[0]])
    parts = np.full(model.nbody, -1)
    for body in range(1, model.nbody):  # parents come before their children
        if body in hips:
            parts[body] = hips.index(body)
        else:
            parts[body] = 4 if body == base else parts[model.body_parentid[body]]
    return np.asarray(parts[model.geom_bodyid])


def leg_contacts(data: mujoco.MjData, parts: npt.NDArray[np.int64]) -> frozenset[tuple[str, str]]:
    """Return the pairs of a leg with another leg or with the trunk that touch, by name.

    Args:
        data: State of the model.
        parts: Result of part_of_geoms().
    """
    touching = {tuple(sorted(pair)) for pair in parts[data.contact.geom].tolist()}
    names = (*LEGS, TRUNK)
    return frozenset(
        (names[first], names[second]) for first, second in touching if 0 <= first < second
    )
