"""Builds the MuJoCo model: from the same URDF as the controller's model, or from an MJCF."""

from __future__ import annotations

import mujoco
import numpy as np

from surefoot._core import Error, Robot
from surefoot.geometry.rotations import Array
from surefoot.messages.low_state_layout import LEGS
from surefoot.robot.loading import RobotDescription
from surefoot.sim.mjcf.find import find_parts
from surefoot.sim.mjcf.scene import mjcf_scene
from surefoot.sim.model.backlash import add_backlash
from surefoot.sim.model.leg_collisions import exclude_overlapping_pairs
from surefoot.sim.model.moving_ground import BLOCK, add_block, place_block
from surefoot.sim.model.scene import GROUND, TERRAIN
from surefoot.sim.model.soft_ground import set_contact_stiffness
from surefoot.sim.model.urdf import load_urdf, one_line, root_body
from surefoot.sim.model.urdf_scene import urdf_scene
from surefoot.sim.settings import PlantSettings

IMU_SITE = "surefoot_imu"
PAYLOAD_BODY = "surefoot_payload"


def build_model(
    robot: Robot, description: RobotDescription, settings: PlantSettings, visuals: bool = False
) -> mujoco.MjModel:
    """Build the MuJoCo model of a robot on its ground.

    The model has no actuators: motor torques are written to qfrc_applied. Base, joints, feet and
    ground have the same names whether the model comes from a URDF or from an MJCF.

    Args:
        robot: The robot as the controller knows it.
        description: The files of the robot; its MJCF, if there is one, replaces URDF and SRDF.
        settings: Ground, payload, friction, armature, backlash, step.
        visuals: Whether to add the visual meshes for pictures and hide the collision geometry.

    Raises:
        Error: A joint, foot body or mesh is missing, MuJoCo rejects the file, an element of the
            MJCF is not supported, or a joint with backlash has no rotor inertia.
    """
    position, quaternion = robot.config.p_base_imu, robot.config.quat_base_imu
    if description.mjcf is None:
        spec = urdf_scene(robot, description, settings)
    else:
        spec, imu = mjcf_scene(robot, description.mjcf, settings, visuals)
        position, quaternion = imu.position, imu.quaternion
    add_backlash(spec, robot, settings)
    apply_trunk_flaws(spec, settings)
    add_payload(spec, settings)
    add_block(spec, settings)
    add_imu(spec, position, quaternion)
    add_foot_sensors(spec, robot, settings)
    if visuals and description.mjcf is None:
        from surefoot.sim.model.visuals import add_visuals

        add_visuals(spec, description)
    model = _compile(spec, description)
    own = description.mjcf is None
    if own and settings.leg_collisions and exclude_overlapping_pairs(spec, model, robot):
        model = _compile(spec, description)
    set_contact_stiffness(model, robot, settings)
    place_block(model, robot, settings)
    return model


def _compile(spec: mujoco.MjSpec, description: RobotDescription) -> mujoco.MjModel:
    kind = "URDF" if description.mjcf is None else "MJCF"
    path = description.mjcf or description.urdf
    try:
        return spec.compile()
    except ValueError as problem:
        raise Error(f"{kind} '{path}': MuJoCo rejects it: {one_line(problem)}") from None


def find_trunk(spec: mujoco.MjSpec) -> mujoco.MjsBody:
    """Return the trunk: the heaviest of the base and the bodies fixed to the base."""
    base = root_body(spec)
    fixed = [base, *(body for body in base.bodies if not body.joints)]
    return max(fixed, key=lambda body: float(body.mass))


def trunk_mass(robot: Robot, description: RobotDescription) -> float:
    """Return the trunk's mass [kg] in the plant; raise Error if a file or mesh is missing."""
    if description.mjcf is None:
        return float(find_trunk(load_urdf(description)).mass)
    parts = find_parts(description.mjcf, robot)
    model, base = parts.model, parts.tree.base
    # The bodies among which find_trunk() chooses. The file need not have their masses.
    below = (model.body_parentid == base) & (model.body_weldid == base)
    return float(max(model.body_mass[base], *model.body_mass[below], 0.0))


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


def add_imu(spec: mujoco.MjSpec, position: Array, quaternion: Array) -> None:
    """Add the IMU at a position [m] and with a rotation w x y z from IMU to base axes."""
    root_body(spec).add_site(name=IMU_SITE, pos=position, quat=quaternion)
    for kind, name in (
        (mujoco.mjtSensor.mjSENS_GYRO, "gyro"),
        (mujoco.mjtSensor.mjSENS_ACCELEROMETER, "accelerometer"),
        (mujoco.mjtSensor.mjSENS_FRAMEQUAT, "quaternion"),
    ):
        spec.add_sensor(name=name, type=kind, objtype=mujoco.mjtObj.mjOBJ_SITE, objname=IMU_SITE)


def add_foot_sensors(spec: mujoco.MjSpec, robot: Robot, settings: PlantSettings) -> None:
    """Add a sensor of the net ground force for each foot."""
    has_terrain = any(geom.name.startswith(TERRAIN) for geom in spec.worldbody.geoms)
    for leg, name in zip(LEGS, robot.config.foot_frames, strict=True):
        # With a terrain, the ground is all of the world's geoms.
        ground = (mujoco.mjtObj.mjOBJ_GEOM, BLOCK if leg == settings.block_foot else GROUND)
        if has_terrain:
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
