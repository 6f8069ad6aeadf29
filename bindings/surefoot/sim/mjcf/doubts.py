"""Values of an MJCF that are possible but unusual, or unlike those of the controller's robot."""

from __future__ import annotations

import numpy as np

from surefoot._core import Robot
from surefoot.sim.mjcf.conventions import mjcf_legs, robot_legs
from surefoot.sim.mjcf.find import MjcfParts
from surefoot.sim.mjcf.names import body_name, joint_name

# Largest difference of link lengths, as a share. Chosen: the known files of one robot differ by
# less than 2 %, and neighbouring robots (go1, aliengo) by 17 %.
_MAX_LENGTH_DIFFERENCE = 0.1
# Largest ratio of rotor inertias, either way. Found with docs/benchmarks/foreign-plants.md: a go2
# whose file has two to four times our inertia falls when it trots.
_MAX_ARMATURE_RATIO = 1.5


def doubts_of(parts: MjcfParts, robot: Robot) -> list[str]:
    """Return one sentence for each doubtful kind of value."""
    lengths = length_doubts(parts, robot, _MAX_LENGTH_DIFFERENCE)
    found = [f"{text}; is it another robot (--robot)?" for text in lengths]
    return [*found, *_armature_doubts(parts, robot), *_base_doubts(parts)]


def length_doubts(parts: MjcfParts, robot: Robot, share: float) -> list[str]:
    """Return one sentence for each kind of link whose length differs by more than a share."""
    theirs = mjcf_legs(parts.model, parts.tree, parts.feet)[0].lengths
    ours = robot_legs(robot)[0].lengths
    return [
        f"{name} of '{robot.name}' is {own:.3f} m long, in the file {length:.3f} m"
        for name, own, length in zip(("thigh", "calf"), ours, theirs, strict=True)
        if abs(length - own) > share * own
    ]


def _armature_doubts(parts: MjcfParts, robot: Robot) -> list[str]:
    """Return a sentence on the rotor inertia that differs most from the controller's."""
    joints = [joint for leg in parts.tree.legs for joint in leg]
    theirs = parts.model.dof_armature[parts.model.jnt_dofadr[joints]]
    ours = np.array(robot.config.armature)
    ratios = np.abs(np.log(np.maximum(theirs, 1e-9) / np.maximum(ours, 1e-9)))
    k = int(ratios.argmax())
    if ratios[k] <= np.log(_MAX_ARMATURE_RATIO):
        return []
    return [
        f"armature of joint '{joint_name(parts.model, joints[k])}' is {theirs[k]:.4g} kg.m^2, that "
        f"of '{robot.name}' {ours[k]:.4g} kg.m^2; the controller may fall when it walks"
    ]


def _base_doubts(parts: MjcfParts) -> list[str]:
    """Return a sentence on a free joint with damping or armature, which a default class gives."""
    model, base = parts.model, parts.tree.base
    dofs = slice(int(model.body_dofadr[base]), int(model.body_dofadr[base]) + 6)
    if not (model.dof_damping[dofs].any() or model.dof_armature[dofs].any()):
        return []
    return [
        f"free joint of body '{body_name(model, base)}' has damping or armature, which brakes the "
        "base in the air; use <freejoint/>"
    ]
