"""Builds the MuJoCo model from the same URDF as the controller's model."""

from __future__ import annotations

import mujoco
import numpy as np

from surefoot._core import Error, Robot
from surefoot.messages.low_state_layout import LEGS
from surefoot.robot.loading import RobotDescription, per_motor
from surefoot.robot.srdf import read_disabled_collisions
from surefoot.robot.urdf import read_urdf
from surefoot.sim.model.backlash import add_backlash
from surefoot.sim.model.leg_collisions import exclude_overlapping_pairs
from surefoot.sim.model.moving_ground import BLOCK, PLATFORM, add_block, place_block
from surefoot.sim.model.scene import (
    BODY_FRICTION,
    FOOT_SOLIMP,
    FOOT_SOLREF,
    GROUND,
    add_ground,
    add_light_and_sky,
    add_terrain,
    set_physics,
)
from surefoot.sim.model.soft_ground import add_soft_contacts, set_contact_stiffness
from surefoot.sim.model.urdf import load_urdf, one_line, root_body
from surefoot.sim.settings import PlantSettings

IMU_SITE = "surefoot_imu"
PAYLOAD_BODY = "surefoot_payload"


def build_model(
    robot: Robot, description: RobotDescription, settings: PlantSettings, visuals: bool = False
) -> mujoco.MjModel:
    """Build the MuJoCo model of a robot on its ground.

    The model has no actuators: motor torques are written to qfrc_applied.

    Args:
        robot: The robot as the controller knows it.
        description: The files of the robot.
        settings: Ground, payload, friction, armature, backlash, step.
        visuals: Whether to add the visual meshes for pictures and hide the collision geometry.

    Raises:
        Error: A joint, foot body or mesh is missing, MuJoCo rejects the URDF, or a joint with
            backlash has no rotor inertia.
    """
    spec = load_urdf(description)
    set_physics(spec, settings)
    add_ground(spec, settings)
    add_terrain(spec, settings)
    add_light_and_sky(spec)
    set_joints(spec, robot, description, settings)
    add_backlash(spec, robot, settings)
    set_contacts(spec, robot, settings)
    add_soft_contacts(spec, robot, settings)
    if not settings.leg_collisions:
        exclude_collision_pairs(spec, description)
    apply_trunk_flaws(spec, settings)
    add_payload(spec, settings)
    add_block(spec, settings)
    add_sensors(spec, robot, settings)
    if visuals:
        from surefoot.sim.model.visuals import add_visuals

        add_visuals(spec, description)
    model = _compile(spec, description)
    if settings.leg_collisions and exclude_overlapping_pairs(spec, model, robot):
        model = _compile(spec, description)
    set_contact_stiffness(model, robot, settings)
    place_block(model, robot, settings)
    return model


def _compile(spec: mujoco.MjSpec, description: RobotDescription) -> mujoco.MjModel:
    try:
        return spec.compile()
    except ValueError as problem:
        raise Error(f"URDF '{description.urdf}': MuJoCo rejects it: {one_line(problem)}") from None


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


def find_trunk(spec: mujoco.MjSpec) -> mujoco.MjsBody:
    """Return the trunk: the heaviest of the base and the bodies fixed to the base."""
    base = root_body(spec)
    fixed = [base, *(body for body in base.bodies if not body.joints)]
    return max(fixed, key=lambda body: float(body.mass))


def trunk_mass(description: RobotDescription) -> float:
    """Return the trunk's mass [kg]; raise Error if the URDF or a mesh is missing."""
    return float(find_trunk(load_urdf(description)).mass)


def apply_trunk_flaws(spec: mujoco.MjSpec, settings: PlantSettings) -> None:
    """Scale the trunk's mass and inertia, and shift its centre of mass."""
    scale, shift = settings.flaws.trunk_mass_scale, settings.flaws.trunk_com_shift
    trunk = find_trunk(spec)
    trunk.mass *= scale
    trunk.fullinertia = trunk.fullinertia * scale
    trunk.inertia = trunk.inertia * scale
    trunk.ipos = trunk.ipos + np.array(shift)


def add_payload(spec: mujoco.MjSpec, settings: PlantSettings) -> None:
    """Weld the payload to the base, as a cube with the density of water."""
    mass = settings.payload_kg
    if mass <= 0.0:
        return
    cube_edge = (mass / 1000.0) ** (1.0 / 3.0)  # [m] water: 1000 kg/m^3
    body = root_body(spec).add_body(name=PAYLOAD_BODY, pos=settings.payload_position)
    body.mass = mass
    body.inertia = [mass * cube_edge**2 / 6.0] * 3
    body.ipos = [0.0, 0.0, 0.0]
    body.explicitinertial = True
    body.add_geom(
        name=PAYLOAD_BODY,
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=[cube_edge / 2.0] * 3,
        contype=0,
        conaffinity=0,
        density=0.0,
        rgba=[0.85, 0.55, 0.2, 1.0],
    )


def add_sensors(spec: mujoco.MjSpec, robot: Robot, settings: PlantSettings) -> None:
    """Add the IMU at its mount, and for each foot a sensor of the net ground force."""
    root_body(spec).add_site(
        name=IMU_SITE, pos=robot.config.p_base_imu, quat=robot.config.quat_base_imu
    )
    for kind, name in (
        (mujoco.mjtSensor.mjSENS_GYRO, "gyro"),
        (mujoco.mjtSensor.mjSENS_ACCELEROMETER, "accelerometer"),
        (mujoco.mjtSensor.mjSENS_FRAMEQUAT, "quaternion"),
    ):
        spec.add_sensor(name=name, type=kind, objtype=mujoco.mjtObj.mjOBJ_SITE, objname=IMU_SITE)
    for leg, name in zip(LEGS, robot.config.foot_frames, strict=True):
        # With a terrain, the ground is all of the world's geoms.
        ground = (mujoco.mjtObj.mjOBJ_GEOM, BLOCK if leg == settings.block_foot else GROUND)
        if not settings.terrain.is_flat:
            ground = (mujoco.mjtObj.mjOBJ_BODY, "world")
        spec.add_sensor(
            name=name,
            type=mujoco.mjtSensor.mjSENS_CONTACT,
            objtype=ground[0],
            objname=ground[1],
            reftype=mujoco.mjtObj.mjOBJ_GEOM,
            refname=name,
            # Fields, reduction of contacts (3: net force, world axes), number of contacts.
            intprm=[1 << int(mujoco.mjtConDataField.mjCONDATA_FORCE), 3, 1],
        )
