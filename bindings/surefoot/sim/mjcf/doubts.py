"""Values of an MJCF that are possible but unusual, or unlike those of the controller's robot."""

from __future__ import annotations

import numpy as np

from surefoot._core import Robot
from surefoot.geometry.rotations import Array
from surefoot.messages.low_state_layout import LEGS
from surefoot.sim.mjcf.conventions import mjcf_legs, robot_legs
from surefoot.sim.mjcf.find import MjcfParts
from surefoot.sim.mjcf.names import body_name, joint_name

# Largest difference of link lengths, as a share. Chosen: the known files of one robot differ by
# less than 2 %, and neighbouring robots (go1, aliengo) by 17 %.
_MAX_LENGTH_DIFFERENCE = 0.1
# [m] Largest difference of hip positions. Chosen: the known files of one robot differ by less than
# 1 mm, and neighbouring robots by centimetres (go1, aliengo: 5 cm).
_MAX_HIP_DIFFERENCE = 0.02
# Largest ratio of rotor inertias, either way. Chosen: larger ratios were found in the known files,
# and the controller has to learn them (docs/benchmarks/foreign-plants.md).
_MAX_ARMATURE_RATIO = 1.5


def doubts_of(parts: MjcfParts, robot: Robot) -> list[str]:
    """Return one sentence for each doubtful kind of value."""
    legs = [*length_doubts(parts, robot, _MAX_LENGTH_DIFFERENCE), *_hip_doubts(parts, robot)]
    found = [f"{text}; is it another robot (--robot)?" for text in legs]
    return [*found, *_armature_doubts(parts, robot), *_base_doubts(parts)]


def length_doubts(parts: MjcfParts, robot: Robot, share: float) -> list[str]:
    """Return a sentence for each kind of link whose length differs by more than a share.

    It names the leg that differs most.
    """
    theirs = np.array([leg.lengths for leg in mjcf_legs(parts.model, parts.tree, parts.feet)])
    ours = np.array([leg.lengths for leg in robot_legs(robot)])
    shares = np.abs(theirs - ours) / ours
    doubts = []
    for k, name in enumerate(("thigh", "calf")):
        # Rounded, so that the first of equal legs is named.
        leg = int(shares[:, k].round(6).argmax())
        if shares[leg, k] > share:
            doubts.append(
                f"{name} of leg {LEGS[leg]} of '{robot.name}' is {ours[leg, k]:.3f} m long, in the "
                f"file {theirs[leg, k]:.3f} m"
            )
    return doubts


def _hip_doubts(parts: MjcfParts, robot: Robot) -> list[str]:
    """Return a sentence on the hip whose position in the base frame differs most."""
    theirs = [leg.hip_point for leg in mjcf_legs(parts.model, parts.tree, parts.feet)]
    ours = [leg.hip_point for leg in robot_legs(robot)]
    distances = np.linalg.norm(np.array(theirs) - np.array(ours), axis=1)
    leg = int(distances.round(6).argmax())
    if distances[leg] <= _MAX_HIP_DIFFERENCE:
        return []
    own, other = _point(ours[leg]), _point(theirs[leg])
    return [f"hip of leg {LEGS[leg]} is at {own} m, in the file at {other} m"]


def _point(position: Array) -> str:
    # Zero is added so that -0.000 becomes 0.000.
    return f"({', '.join(f'{value:.3f}' for value in position.round(3) + 0.0)})"


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
        f"of '{robot.name}' {ours[k]:.4g} kg.m^2; the controller learns it when it steps"
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
