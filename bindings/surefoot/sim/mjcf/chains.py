"""Finds the twelve leg joints of a quadruped in a compiled model, and sorts them by leg."""

from __future__ import annotations

import re

import mujoco
import numpy as np

from surefoot._core import Error
from surefoot.geometry.rotations import Array
from surefoot.messages.low_state_layout import LEGS
from surefoot.sim.mjcf.names import body_name, joint_name

_PLACES = {"FR": "front right", "FL": "front left", "RR": "rear right", "RL": "rear left"}
Leg = tuple[int, int, int]
"""Ids of the joints hip, thigh, calf."""


def find_legs(model: mujoco.MjModel, base: int) -> tuple[Leg, ...]:
    """Return the legs FR FL RR RL, by where their hips are.

    Args:
        model: The compiled model.
        base: Body with the free joint.

    Raises:
        Error: The robot has other joints than four chains of three hinges, or the hips are not in
            the four quadrants of the base frame; the message names the joint.
    """
    return _sort_legs(model, base, _find_chains(model, base))


def joints_below(model: mujoco.MjModel, root: int) -> list[int]:
    """Return the joints of a body of the world and of all bodies below it."""
    return [j for j in range(model.njnt) if model.body_rootid[model.jnt_bodyid[j]] == root]


def _find_chains(model: mujoco.MjModel, base: int) -> list[list[int]]:
    """Return the four chains of three hinges each; raise Error if there are other joints."""
    chains: dict[int, list[int]] = {}  # by the last joint of the chain
    for j in joints_below(model, base):  # a parent's joints come before those of its children
        if model.jnt_type[j] == mujoco.mjtJoint.mjJNT_FREE:
            continue
        if model.jnt_type[j] != mujoco.mjtJoint.mjJNT_HINGE:
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


def _anchors(model: mujoco.MjModel, base: int, joints: list[int]) -> Array:
    """Return the points (n, 3) [m] of joints in the base frame, in the file's initial pose."""
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    rotation = data.xmat[base].reshape(3, 3)
    return np.asarray((data.xanchor[joints] - data.xpos[base]) @ rotation)


def _sort_legs(model: mujoco.MjModel, base: int, chains: list[list[int]]) -> tuple[Leg, ...]:
    """Return the chains in the order FR FL RR RL."""
    hips = _anchors(model, base, [chain[0] for chain in chains])[:, :2]
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
