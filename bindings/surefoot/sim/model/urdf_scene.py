"""The scene of a robot from its URDF: joints, contacts and ground as the settings say."""

from __future__ import annotations

import mujoco

from surefoot._core import Error, Robot
from surefoot.robot.loading import RobotDescription, per_motor
from surefoot.robot.srdf import read_disabled_collisions
from surefoot.robot.urdf import read_urdf
from surefoot.sim.model.moving_ground import PLATFORM
from surefoot.sim.model.scene import (
    BODY_FRICTION,
    FOOT_SOLIMP,
    FOOT_SOLREF,
    add_ground,
    add_light_and_sky,
    add_terrain,
    set_physics,
)
from surefoot.sim.model.soft_ground import add_soft_contacts
from surefoot.sim.model.urdf import load_urdf
from surefoot.sim.settings import PlantSettings


def urdf_scene(
    robot: Robot, description: RobotDescription, settings: PlantSettings
) -> mujoco.MjSpec:
    """Return a robot from its URDF on the ground of the settings, without sensors.

    Raises:
        Error: A joint, foot body or mesh is missing, or MuJoCo rejects the URDF.
    """
    spec = load_urdf(description)
    set_physics(spec, settings)
    add_ground(spec, settings)
    add_terrain(spec, settings)
    add_light_and_sky(spec)
    set_joints(spec, robot, description, settings)
    set_contacts(spec, robot, settings)
    add_soft_contacts(spec, robot, settings)
    if not settings.leg_collisions:
        exclude_collision_pairs(spec, description)
    return spec


def set_joints(
    spec: mujoco.MjSpec, robot: Robot, description: RobotDescription, settings: PlantSettings
) -> None:
    """Set armature, friction and damping of the motor joints: from the TOML, else from the URDF."""
    table = description.table.get("simulation", {})
    for i, name in enumerate(robot.config.joint_names):
        joint = spec.joint(name)
        joint.armature = robot.config.armature[i] * settings.armature_scale
        friction, damping = joint.frictionloss, joint.damping[0]
        if "joint_friction" in table:
            friction = per_motor(table["joint_friction"], "simulation.joint_friction")[i]
        if "joint_damping" in table:
            damping = per_motor(table["joint_damping"], "simulation.joint_damping")[i]
        joint.frictionloss = friction * settings.joint_friction_scale
        joint.damping = [damping * settings.joint_friction_scale, 0.0, 0.0]


def set_contacts(spec: mujoco.MjSpec, robot: Robot, settings: PlantSettings) -> None:
    """Replace each foot's geometry by a sphere at its frame; name all geoms after their body."""
    for body in spec.bodies:
        if body.name in ("world", PLATFORM):
            continue
        for k, geom in enumerate(body.geoms):
            geom.name = f"{body.name}_collision_{k}"
            geom.friction = [BODY_FRICTION, 0.005, 0.0001]
    names = [body.name for body in spec.bodies]
    for name in robot.config.foot_frames:
        if name not in names:
            raise Error(
                f"foot frame: got '{name}', expected a link of the URDF: {', '.join(names)}"
            )
        body = spec.body(name)
        for geom in list(body.geoms):
            spec.delete(geom)
        body.add_geom(
            name=name,
            type=mujoco.mjtGeom.mjGEOM_SPHERE,
            size=[robot.config.foot_radius, 0.0, 0.0],
            density=0.0,
            # With this priority, contacts of a foot use the friction and stiffness of the foot.
            priority=1,
            condim=3,
            friction=[settings.friction, 0.005, 0.0001],
            solref=FOOT_SOLREF,
            solimp=FOOT_SOLIMP,
        )


def exclude_collision_pairs(spec: mujoco.MjSpec, description: RobotDescription) -> None:
    """Exclude the collision pairs that the SRDF disables, because neighbouring links overlap."""
    if description.srdf is None:
        return
    # A world link above the base is no body.
    links = read_urdf(description.urdf, description.table).links
    names = {body.name for body in spec.bodies}
    for first, second in read_disabled_collisions(description.srdf, links):
        if first in names and second in names and first != second:
            spec.add_exclude(bodyname1=first, bodyname2=second)
