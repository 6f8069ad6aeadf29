"""Finds the base and the four legs of a quadruped in a compiled model, by its kinematic tree."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco

from surefoot._core import Error
from surefoot.sim.mjcf.chains import Leg, find_legs, joints_below
from surefoot.sim.mjcf.names import body_name, joint_name

_FREE, _HINGE = mujoco.mjtJoint.mjJNT_FREE, mujoco.mjtJoint.mjJNT_HINGE


@dataclass(frozen=True)
class Tree:
    """Base and legs of a quadruped, as ids of the model.

    Attributes:
        base: Body with the free joint.
        legs: Joints hip, thigh, calf of the legs FR FL RR RL.
    """

    base: int
    legs: tuple[Leg, ...]


def find_tree(model: mujoco.MjModel) -> Tree:
    """Find the base by its free joint, and the legs by where their hips are.

    Raises:
        Error: There is not exactly one robot of twelve hinges in four legs; the message names the
            joint or body.
    """
    base = _find_base(model)
    return Tree(base, find_legs(model, base))


def _find_base(model: mujoco.MjModel) -> int:
    free = [j for j in range(model.njnt) if model.jnt_type[j] == _FREE]
    moving = {int(model.body_rootid[model.jnt_bodyid[j]]) for j in range(model.njnt)}
    robots = [
        int(model.jnt_bodyid[j])
        for j in free
        if any(model.jnt_type[k] == _HINGE for k in joints_below(model, int(model.jnt_bodyid[j])))
    ]
    if not robots:
        roots = ", ".join(f"'{body_name(model, body)}'" for body in sorted(moving)) or "none"
        raise Error(
            f"free joint: got no base that moves freely with legs (bodies with joints: {roots}), "
            "expected one; add <freejoint/> to the trunk"
        )
    if len(robots) > 1:
        names = ", ".join(f"'{body_name(model, body)}'" for body in robots)
        raise Error(f"several robots: got the bases {names}, expected one; remove the others")
    base = robots[0]
    for j in range(model.njnt):
        body = int(model.jnt_bodyid[j])
        if model.body_rootid[body] != base:
            raise Error(
                f"body '{body_name(model, body)}': got joint '{joint_name(model, j)}' that moves "
                "it, expected no moving body besides the robot; remove the joint or the body"
            )
    return base
