"""Indices of the robot's parts in MuJoCo's arrays, looked up once by name."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np
import numpy.typing as npt

from surefoot._core import Robot
from surefoot.geometry.rotations import Array, matrix_from_wxyz
from surefoot.sim.model.backlash import rotor_name
from surefoot.sim.model.moving_ground import BLOCK
from surefoot.sim.model.mujoco_model import IMU_SITE
from surefoot.sim.model.scene import GROUND, TERRAIN

Indices = npt.NDArray[np.int64]


@dataclass(frozen=True)
class Handles:
    """Indices into a model's arrays. Twelve entries: SDK motor order; four entries: FR FL RR RL.

    Attributes:
        root: Body of the base.
        motor_q: (12,) indices into qpos: angles on the rotor's side of the gears, where the motor
            torques and the encoders are.
        motor_v: (12,) indices into qvel: velocities on the rotor's side.
        joint_q: (12,) indices into qpos: angles on the link's side; without backlash the same as
            motor_q.
        joint_v: (12,) indices into qvel: velocities on the link's side.
        foot_bodies: (4,) bodies of the feet.
        foot_geoms: (4,) geoms of the foot spheres.
        foot_radius: Radius of the foot spheres [m].
        ground_geom: Geom of the ground plane or platform.
        ground_geoms: ground_geom, and the block under a foot if there is one: only feet may touch
            them. Empty for the ground of an MJCF.
        terrain_geoms: Boxes of PlantSettings.terrain; or ground and obstacles of an MJCF, whose
            soft feet may sink so deep that the calves touch the ground.
        calf_geoms: Geoms of the calves and of bodies fixed to them, which may touch terrain_geoms.
        gyro: (3,) entries of sensordata: angular velocity, IMU axes.
        accelerometer: (3,) entries of sensordata: specific force, IMU axes.
        quaternion: (4,) entries of sensordata: rotation from IMU to world axes, w x y z.
        foot_forces: (4, 3) indices into sensordata: ground force on each foot, world axes.
        ground_normal: (3,) unit vector out of the ground, world axes, when the model is compiled.
    """

    root: int
    motor_q: Indices
    motor_v: Indices
    joint_q: Indices
    joint_v: Indices
    foot_bodies: Indices
    foot_geoms: Indices
    foot_radius: float
    ground_geom: int
    ground_geoms: tuple[int, ...]
    terrain_geoms: frozenset[int]
    calf_geoms: frozenset[int]
    gyro: slice
    accelerometer: slice
    quaternion: slice
    foot_forces: Indices
    ground_normal: Array


def find_handles(
    model: mujoco.MjModel, robot: Robot, calves_may_touch_ground: bool = False
) -> Handles:
    """Return the handles of a model; all parts are looked up by name.

    Args:
        model: Result of build_model().
        robot: The robot.
        calves_may_touch_ground: Whether the ground counts as terrain, as for an MJCF.
    """
    joints, feet = robot.config.joint_names, robot.config.foot_frames
    rotors = [rotor_name(name) for name in joints]
    has_rotors = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, rotors[0]) >= 0
    motors = rotors if has_rotors else joints

    def geom(name: str) -> int:
        return int(mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_GEOM, name))

    def sensor(name: str) -> slice:
        start, size = model.sensor(name).adr[0], model.sensor(name).dim[0]
        return slice(int(start), int(start + size))

    ground = [id for id in map(geom, (GROUND, BLOCK)) if id >= 0]
    terrain = [id for id in range(model.ngeom) if model.geom(id).name.startswith(TERRAIN)]
    if calves_may_touch_ground:
        ground, terrain = [], ground + terrain
    calves = [int(model.joint(name).bodyid[0]) for name in joints[2::3]]
    return Handles(
        root=int(model.site(IMU_SITE).bodyid[0]),
        motor_q=np.array([model.joint(name).qposadr[0] for name in motors]),
        motor_v=np.array([model.joint(name).dofadr[0] for name in motors]),
        joint_q=np.array([model.joint(name).qposadr[0] for name in joints]),
        joint_v=np.array([model.joint(name).dofadr[0] for name in joints]),
        foot_bodies=np.array([model.body(name).id for name in feet]),
        foot_geoms=np.array([model.geom(name).id for name in feet]),
        foot_radius=float(model.geom(feet[0]).size[0]),
        ground_geom=geom(GROUND),
        ground_geoms=tuple(ground),
        terrain_geoms=frozenset(terrain),
        calf_geoms=frozenset(
            np.flatnonzero(np.isin(model.body_weldid[model.geom_bodyid], calves)).tolist()
        ),
        gyro=sensor("gyro"),
        accelerometer=sensor("accelerometer"),
        quaternion=sensor("quaternion"),
        foot_forces=np.array([np.arange(sensor(name).start, sensor(name).stop) for name in feet]),
        ground_normal=matrix_from_wxyz(model.geom(GROUND).quat)[:, 2],
    )
