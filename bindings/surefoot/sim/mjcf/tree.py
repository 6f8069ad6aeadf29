"""Finds the base and the four legs of a quadruped in a compiled model, by its kinematic tree."""

from __future__ import annotations

import re
from dataclasses import dataclass

import mujoco
import numpy as np

from surefoot._core import Error
from surefoot.geometry.rotations import Array
from surefoot.messages.low_state_layout import LEGS

_PLACES = {"FR": "front right", "FL": "front left", "RR": "rear right", "RL": "rear left"}
_FREE, _HINGE = mujoco.mjtJoint.mjJNT_FREE, mujoco.mjtJoint.mjJNT_HINGE


@dataclass(frozen=True)
class Tree:
    """Base and legs of a quadruped, as ids of the model.

    Attributes:
        base: Body with the free joint.
        legs: Joints hip, thigh, calf of the legs FR FL RR RL.
    """

    base: int
    legs: tuple[tuple[int, int, int], ...]


def element_name(model: mujoco.MjModel, kind: mujoco.mjtObj, index: int) -> str:
    """Return the name of an element, or words for an element without a name."""
    name: str | None = mujoco.mj_id2name(model, kind, index)
    return name or f"number {index} of the file, without a name"


def joint_name(model: mujoco.MjModel, joint: int) -> str:
    """Return the name of a joint as element_name() does."""
    return element_name(model, mujoco.mjtObj.mjOBJ_JOINT, joint)


def body_name(model: mujoco.MjModel, body: int) -> str:
    """Return the name of a body as element_name() does."""
    return element_name(model, mujoco.mjtObj.mjOBJ_BODY, body)


def find_tree(model: mujoco.MjModel) -> Tree:
    """Find the base by its free joint, and the legs by where their hips are.

    Raises:
        Error: There is not exactly one robot of twelve hinges in four legs; the message names the
            joint or body.
    """
    base = _find_base(model)
    return Tree(base, _sort_legs(model, base, _find_chains(model, base)))


def _find_base(model: mujoco.MjModel) -> int:
    free = [j for j in range(model.njnt) if model.jnt_type[j] == _FREE]
    hinges = {int(model.body_rootid[model.jnt_bodyid[j]]) for j in range(model.njnt)}
    robots = [
        int(model.jnt_bodyid[j])
        for j in free
        if any(model.jnt_type[k] == _HINGE for k in _joints_below(model, int(model.jnt_bodyid[j])))
    ]
    if not robots:
        roots = ", ".join(f"'{body_name(model, body)}'" for body in sorted(hinges)) or "none"
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


def _joints_below(model: mujoco.MjModel, root: int) -> list[int]:
    return [j for j in range(model.njnt) if model.body_rootid[model.jnt_bodyid[j]] == root]


def _find_chains(model: mujoco.MjModel, base: int) -> list[list[int]]:
    """Return the four chains of three hinges each; raise Error if there are other joints."""
    chains: dict[int, list[int]] = {}  # by the last joint of the chain
    for j in _joints_below(model, base):  # a parent's joints come before those of its children
        if model.jnt_type[j] == _FREE:
            continue
        if model.jnt_type[j] != _HINGE:
            kind = mujoco.mjtJoint(int(model.jnt_type[j])).name.removeprefix("mjJNT_").lower()
            raise Error(
                f"joint '{joint_name(model, j)}': got a {kind} joint, expected hinges only; "
                "remove it"
            )
        parent = _previous_joint(model, base, j)
        if parent is None:
            chains[j] = [j]
        elif parent in chains:
            chains[j] = [*chains.pop(parent), j]
        else:
            raise Error(
                f"joint '{joint_name(model, j)}': got a second joint behind "
                f"'{joint_name(model, parent)}', expected one chain for each leg; remove it"
            )
    found = list(chains.values())
    legs = [chain for chain in found if len(chain) == 3]
    for chain in found:
        if len(chain) > 3 and len(legs) < 4:
            raise Error(
                f"joint '{joint_name(model, chain[3])}': got a fourth joint in a leg, expected "
                "hip, thigh and calf; remove it (a wheel becomes a fixed foot)"
            )
        if len(chain) != 3:
            raise Error(
                f"joint '{joint_name(model, chain[0])}': got a chain of {len(chain)} joints at "
                f"body '{body_name(model, int(model.jnt_bodyid[chain[0]]))}', expected four legs "
                "of three; remove its joints (an arm becomes a fixed payload)"
            )
    if len(legs) != 4:
        names = ", ".join(f"'{joint_name(model, chain[0])}'" for chain in legs)
        raise Error(f"legs: got {len(legs)} chains of three joints ({names}), expected four")
    return legs


def _previous_joint(model: mujoco.MjModel, base: int, joint: int) -> int | None:
    """Return the hinge before this one on the way from the base, or None."""
    body = int(model.jnt_bodyid[joint])
    if joint > model.body_jntadr[body]:
        return joint - 1
    while (body := int(model.body_parentid[body])) != base:
        if model.body_jntnum[body]:
            return int(model.body_jntadr[body] + model.body_jntnum[body] - 1)
    return None


def base_frame_anchors(model: mujoco.MjModel, base: int, joints: list[int]) -> Array:
    """Return the points (n, 3) [m] of joints in the base frame, in the file's initial pose."""
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    rotation = data.xmat[base].reshape(3, 3)
    return np.asarray((data.xanchor[joints] - data.xpos[base]) @ rotation)


def _sort_legs(
    model: mujoco.MjModel, base: int, chains: list[list[int]]
) -> tuple[tuple[int, int, int], ...]:
    """Return the chains in the order FR FL RR RL."""
    hips = base_frame_anchors(model, base, [chain[0] for chain in chains])[:, :2]
    forward, left = (hips > hips.mean(axis=0)).T
    places = [LEGS[2 * (not front) + bool(side)] for front, side in zip(forward, left, strict=True)]
    if sorted(places) != sorted(LEGS):
        points = ", ".join(f"({x:.3f}, {y:.3f})" for x, y in hips)
        raise Error(
            f"legs: got hips at x, y {points} m in the base frame of body "
            f"'{body_name(model, base)}', expected one in each quadrant, x forward and y left"
        )
    for place, chain in zip(places, chains, strict=True):
        name = joint_name(model, chain[0])
        named = re.match(r"(FR|FL|RR|RL)(?![A-Za-z])", name)
        if named and named[1] != place:
            raise Error(
                f"joint '{name}': got a hip {_PLACES[place]} of the base, expected "
                f"{_PLACES[named[1]]} by its name; the x axis of body '{body_name(model, base)}' "
                "must point forward and y left"
            )
    order = [chains[places.index(leg)] for leg in LEGS]
    return tuple((chain[0], chain[1], chain[2]) for chain in order)
