"""Describes what was found in an MJCF file."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import mujoco
import numpy as np

from surefoot._core import Error, Robot
from surefoot.robot.description import RobotDescription
from surefoot.robot.loading import build_robot
from surefoot.sim.mjcf.doubts import doubts_of
from surefoot.sim.mjcf.find import MjcfParts, find_parts
from surefoot.sim.mjcf.integrator import integrator_name, is_usable_integrator
from surefoot.sim.mjcf.mapping import FootMatch, JointMatch, ModelMapping
from surefoot.sim.mjcf.names import body_name, geom_name, joint_name


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
        doubts=tuple(doubts_of(parts, robot)),
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
    notes = [
        "friction, soft_soles and leg_collisions are those of the file's contacts; the settings of "
        "these names have no effect"
    ]
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
    floating = [b for b in range(model.nbody) if model.body_gravcomp[b]]
    if floating:
        values = ", ".join(
            f"{model.body_gravcomp[b]:g} in '{body_name(model, b)}'" for b in floating
        )
        notes.append(f"gravcomp of the file is used and cancels this share of gravity: {values}")
    if spec.option.density or spec.option.viscosity:
        wind = " ".join(f"{speed:g}" for speed in spec.option.wind)
        notes.append(
            f"density {spec.option.density:g}, viscosity {spec.option.viscosity:g} and wind {wind} "
            "of the file are used: a fluid acts on the bodies"
        )
    integrator = integrator_name(spec)
    used = integrator if is_usable_integrator(spec) else f"EULER instead of {integrator}"
    notes.append(
        f"integrator {used.lower()}, cone, solver and impratio {spec.option.impratio:g} of the "
        f"file; its timestep, {spec.option.timestep:g} s, is replaced by physics_dt"
    )
    return notes


def _actuator_kind(model: mujoco.MjModel, k: int) -> str:
    """Return "motor", "position", "velocity" or "other" for an actuator."""
    kp, kv = -float(model.actuator_biasprm[k, 1]), -float(model.actuator_biasprm[k, 2])
    if model.actuator_biastype[k] == mujoco.mjtBias.mjBIAS_NONE:
        fixed = model.actuator_gaintype[k] == mujoco.mjtGain.mjGAIN_FIXED
        return "motor" if fixed else "other"
    return "position" if kp else "velocity" if kv else "other"
