"""Gives the parts of an MJCF file the names and joint conventions of the controller's robot.

After that the plant treats the model as it treats its own. Masses, joint friction, damping,
armature, contacts, cone and solver stay those of the file.
"""

from __future__ import annotations

import math
from typing import Any

import mujoco
import numpy as np

from surefoot._core import Robot
from surefoot.sim.mjcf.find import MjcfParts
from surefoot.sim.mjcf.integrator import is_usable_integrator
from surefoot.sim.model.scene import GROUND, TERRAIN
from surefoot.sim.settings import PlantSettings


def adapt_mjcf(parts: MjcfParts, robot: Robot, settings: PlantSettings, visuals: bool) -> None:
    """Change parts.spec to a model of which joints, feet and ground have the robot's names.

    The specification can be compiled afterwards; parts.model then no longer belongs to it.

    Args:
        parts: The parts that were found.
        robot: The controller's robot.
        settings: Physics step, and factors on joint friction and armature.
        visuals: Whether to keep geoms that do not collide, for pictures.
    """
    spec = parts.spec
    # Ids become invalid when an element is added or deleted.
    geoms, bodies, joints = (
        {element.id: element for element in elements}
        for elements in (spec.geoms, spec.bodies, spec.joints)
    )
    _fix_inertias(parts, bodies)
    _name_geoms(parts, robot, geoms)
    _name_bodies(parts, robot, bodies)
    _set_joints(parts, robot, settings, joints)
    _set_options(spec, settings)
    for unused in (spec.actuators, spec.sensors, spec.keys, spec.equalities):
        for element in list(unused):
            spec.delete(element)
    spec.compiler.discardvisual = not visuals


def _set_options(spec: mujoco.MjSpec, settings: PlantSettings) -> None:
    spec.option.timestep = settings.physics_dt
    if not is_usable_integrator(spec):
        spec.option.integrator = mujoco.mjtIntegrator.mjINT_EULER
    spec.option.disableflags &= ~int(mujoco.mjtDisableBit.mjDSBL_SENSOR)
    # A simulation that diverges must not start again from the file's initial pose: its NaN state
    # counts as a fall.
    spec.option.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_AUTORESET)


def _fix_inertias(parts: MjcfParts, bodies: dict[int, Any]) -> None:
    """Write the compiled inertias to the specification.

    Otherwise further geoms and bodies could change them, and geoms that only have mass could not be
    left out.
    """
    model, compiler = parts.model, parts.spec.compiler
    for number, body in bodies.items():
        if number == 0:
            continue
        body.explicitinertial, body.mass = True, float(model.body_mass[number])
        body.ipos, body.iquat = model.body_ipos[number], model.body_iquat[number]
        body.fullinertia = [np.nan, 0.0, 0.0, 0.0, 0.0, 0.0]
        body.ialt.type = mujoco.mjtOrientation.mjORIENTATION_QUAT
        body.inertia = model.body_inertia[number]
    compiler.inertiafromgeom = mujoco.mjtInertiaFromGeom.mjINERTIAFROMGEOM_FALSE
    compiler.balanceinertia, compiler.settotalmass = False, -1.0
    compiler.boundmass = compiler.boundinertia = 0.0


def _rename(elements: dict[int, Any], names: dict[int, str]) -> dict[str, str]:
    """Name elements by their ids; other elements with one of these names get another one.

    Returns:
        The new name of each name that has changed.
    """
    changed, taken = {}, set(names.values())
    for number, element in elements.items():
        old = element.name
        new = names.get(number, f"{old} of the file" if old in taken else old)
        if new == old:
            continue
        element.name = new
        if old:  # no reference means an element without a name
            changed[old] = new
    return changed


def _name_geoms(parts: MjcfParts, robot: Robot, geoms: dict[int, Any]) -> None:
    """Name feet, ground and obstacles; add a ground if there is none."""
    spec, ground = parts.spec, parts.ground
    names = {f.geom: n for f, n in zip(parts.feet, robot.config.foot_frames, strict=True)}
    names |= {geom: f"{TERRAIN}_{k}" for k, geom in enumerate(ground.obstacles)}
    if ground.plane is not None:
        names[ground.plane] = GROUND
    changed = _rename(geoms, names)
    for pair in spec.pairs:
        pair.geomname1 = changed.get(pair.geomname1, pair.geomname1)
        pair.geomname2 = changed.get(pair.geomname2, pair.geomname2)
    if ground.plane is None:
        _add_plane(spec)
    elif not np.array_equal(parts.model.geom_quat[ground.plane], [1.0, 0.0, 0.0, 0.0]):
        # The robot starts parallel to the ground's axes, and x ahead.
        plane = geoms[ground.plane]
        plane.alt.type, plane.quat = mujoco.mjtOrientation.mjORIENTATION_QUAT, [1.0, 0.0, 0.0, 0.0]


def _add_plane(spec: mujoco.MjSpec) -> None:
    """Add a level plane whose contacts have the friction and stiffness of the other geom.

    MuJoCo uses the larger of two friction coefficients and contact dimensions, and weighs the
    stiffness by solmix. All values of contacts are set here, because a new geom has those of the
    file's default class "main".
    """
    spec.worldbody.add_geom(
        name=GROUND,
        type=mujoco.mjtGeom.mjGEOM_PLANE,
        size=[0.0, 0.0, 0.5],
        pos=[0.0, 0.0, 0.0],
        quat=[1.0, 0.0, 0.0, 0.0],
        contype=1,
        conaffinity=1,
        priority=0,
        friction=[0.0, 0.0, 0.0],
        condim=1,
        margin=0.0,
        gap=0.0,
        solmix=0.0,
        solref=[0.02, 1.0],
        solimp=[0.9, 0.95, 0.001, 0.5, 2.0],
        rgba=[0.75, 0.78, 0.82, 1.0],
    )


def _name_bodies(parts: MjcfParts, robot: Robot, bodies: dict[int, Any]) -> None:
    """Add a body without mass at the centre of each foot, with the name of the foot frame."""
    spec = parts.spec
    # A negative id belongs to no element: the names are only reserved.
    names = {-1 - leg: name for leg, name in enumerate(robot.config.foot_frames)}
    names |= {number: f"body_{number}" for number, body in bodies.items() if not body.name}
    changed = _rename(bodies, names)
    for exclude in spec.excludes:
        exclude.bodyname1 = changed.get(exclude.bodyname1, exclude.bodyname1)
        exclude.bodyname2 = changed.get(exclude.bodyname2, exclude.bodyname2)
    for tracker in (*spec.cameras, *spec.lights):
        tracker.targetbody = changed.get(tracker.targetbody, tracker.targetbody)
    for foot, name in zip(parts.feet, robot.config.foot_frames, strict=True):
        body = bodies[foot.body].add_body(name=name, pos=foot.centre)
        body.explicitinertial, body.mass, body.ipos = True, 0.0, [0.0, 0.0, 0.0]


def _set_joints(
    parts: MjcfParts, robot: Robot, settings: PlantSettings, joints: dict[int, Any]
) -> None:
    """Name the twelve joints, convert their signs and zeros, and scale friction and armature."""
    motors = [joint for leg in parts.tree.legs for joint in leg]
    _rename(joints, dict(zip(motors, robot.config.joint_names, strict=True)))
    for number, convention in zip(motors, parts.conventions, strict=True):
        joint = joints[number]
        joint.armature *= settings.armature_scale
        joint.frictionloss *= settings.joint_friction_scale
        joint.damping = settings.joint_friction_scale * np.array(joint.damping)
        if not convention.converted:
            continue
        unit = 180.0 / math.pi if joint.compiler.degree else 1.0
        sign, old, new = convention.sign, joint.ref, unit * convention.reference
        joint.axis = sign * np.array(joint.axis)
        joint.range = sorted(sign * (np.array(joint.range) - old) + new)
        joint.springref = sign * (joint.springref - old) + new
        joint.ref = new
