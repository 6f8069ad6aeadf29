"""Finds all parts of a robot in an MJCF file, and describes them."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import mujoco
import numpy as np

from surefoot._core import Error, Robot
from surefoot.robot.description import RobotDescription
from surefoot.robot.loading import build_robot
from surefoot.sim.mjcf.conventions import (
    JointConvention,
    joint_conventions,
    mjcf_legs,
    robot_legs,
)
from surefoot.sim.mjcf.feet import Foot, find_feet
from surefoot.sim.mjcf.file import read_mjcf
from surefoot.sim.mjcf.ground import Ground, find_ground, geom_name
from surefoot.sim.mjcf.imu_mount import ImuMount, find_imu
from surefoot.sim.mjcf.mapping import FootMatch, JointMatch, ModelMapping
from surefoot.sim.mjcf.tree import Tree, body_name, find_tree, joint_name

# Largest difference of link lengths, as a share. Chosen: the known files of one robot differ by
# less than 2 %, and neighbouring robots (go1, aliengo) by 17 %.
_MAX_LENGTH_DIFFERENCE = 0.1
_INTEGRATORS = ("EULER", "IMPLICIT", "IMPLICITFAST")
"""Integrators that mj_step2 computes; it replaces all others."""


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


def describe_mjcf(description: RobotDescription) -> ModelMapping:
    """Return what was found in the MJCF of a description.

    Raises:
        Error: The description has no MJCF, or as find_parts().
    """
    if description.mjcf is None:
        raise Error(f"robot '{description.name}': got no MJCF, expected one (mjcf= or --mjcf)")
    robot = build_robot(description)
    return mapping_of(find_parts(description.mjcf, robot), description.mjcf, robot)


def mapping_of(parts: MjcfParts, path: Path, robot: Robot) -> ModelMapping:
    """Describe the parts that were found in a file."""
    model, tree = parts.model, parts.tree
    x, y, z = map(float, parts.imu.position)
    plane = parts.ground.plane
    return ModelMapping(
        path=path,
        robot=robot.name,
        base=body_name(model, tree.base),
        mass=float(model.body_subtreemass[tree.base]),
        joints=_joint_matches(parts, robot),
        feet=tuple(
            FootMatch(frame, geom_name(model, foot.geom), body_name(model, foot.body), foot.radius)
            for frame, foot in zip(robot.config.foot_frames, parts.feet, strict=True)
        ),
        imu=parts.imu.source,
        imu_position=(x, y, z),
        ground="a plane is added, with the contact parameters of the feet"
        if plane is None
        else f"geom '{geom_name(model, plane)}'",
        notes=tuple(_notes(parts)),
        doubts=tuple(length_doubts(parts, robot)),
    )


def _joint_matches(parts: MjcfParts, robot: Robot) -> tuple[JointMatch, ...]:
    model, joints = parts.model, [joint for leg in parts.tree.legs for joint in leg]
    matches = []
    for motor, joint, convention in zip(
        robot.config.joint_names, joints, parts.conventions, strict=True
    ):
        dof, start = int(model.jnt_dofadr[joint]), model.qpos0[model.jnt_qposadr[joint]]
        matches.append(
            JointMatch(
                motor,
                joint_name(model, joint),
                convention.sign,
                convention.reference - convention.sign * float(start),
                float(model.dof_armature[dof]),
                float(np.atleast_1d(model.dof_damping[dof])[0]),
                float(model.dof_frictionloss[dof]),
            )
        )
    return tuple(matches)


def _notes(parts: MjcfParts) -> list[str]:
    model, spec = parts.model, parts.spec
    notes = []
    kinds = Counter(_actuator_kind(model, k) for k in range(model.nu))
    if kinds:
        which = ", ".join(f"{count} {kind}" for kind, count in sorted(kinds.items()))
        notes.append(
            f"actuators are off, with their gains: {which}; the motor law of the plant acts on the "
            "joints"
        )
    if model.nkey:
        names = ", ".join(f"'{model.key(k).name}'" for k in range(model.nkey))
        notes.append(f"keyframes are not used: {names}; the robot starts in its standing pose")
    if parts.ground.obstacles:
        names = ", ".join(f"'{geom_name(model, geom)}'" for geom in parts.ground.obstacles)
        notes.append(f"obstacles, which only feet and calves may touch: {names}")
    integrator = integrator_name(spec)
    used = integrator if integrator in _INTEGRATORS else "EULER instead of " + integrator
    notes.append(
        f"integrator {used.lower()}, cone, solver and impratio {spec.option.impratio:g} of the "
        f"file; its timestep, {spec.option.timestep:g} s, is replaced by physics_dt"
    )
    return notes


def integrator_name(spec: mujoco.MjSpec) -> str:
    """Return the name of the file's integrator, such as EULER."""
    name: str = mujoco.mjtIntegrator(int(spec.option.integrator)).name
    return name.removeprefix("mjINT_")


def is_usable_integrator(spec: mujoco.MjSpec) -> bool:
    """Return whether the plant can use the file's integrator."""
    return integrator_name(spec) in _INTEGRATORS


def _actuator_kind(model: mujoco.MjModel, k: int) -> str:
    """Return "motor", "position", "velocity" or "other" for an actuator."""
    kp, kv = -float(model.actuator_biasprm[k, 1]), -float(model.actuator_biasprm[k, 2])
    if model.actuator_biastype[k] == mujoco.mjtBias.mjBIAS_NONE:
        fixed = model.actuator_gaintype[k] == mujoco.mjtGain.mjGAIN_FIXED
        return "motor" if fixed else "other"
    return "position" if kp else "velocity" if kv else "other"


def length_doubts(
    parts: MjcfParts, robot: Robot, share: float = _MAX_LENGTH_DIFFERENCE
) -> list[str]:
    """Return one sentence for each kind of link whose length differs by more than a share."""
    theirs = mjcf_legs(parts.model, parts.tree, parts.feet)[0].lengths
    ours = robot_legs(robot)[0].lengths
    return [
        f"{name} of '{robot.name}' is {own:.3f} m long, in the file {length:.3f} m; is it another "
        "robot (--robot)?"
        for name, own, length in zip(("thigh", "calf"), ours, theirs, strict=True)
        if abs(length - own) > share * own
    ]
