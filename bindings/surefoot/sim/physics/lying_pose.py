"""Lying poses: the robot is dropped with random joint angles and braking motors until it rests."""

from __future__ import annotations

import mujoco
import numpy as np

from surefoot._core import Robot
from surefoot.geometry.rotations import Array
from surefoot.sim.model.mujoco_handles import Handles

# Chosen by hand; tests: test_plant_lying_pose.py.
FIRST_CHECK_TIME = 1.0  # [s] time after a drop when most failing drops can be detected
LYING_SETTLE_TIME = 4.0  # [s] time after a drop when braking motors have lowered the body
# [m/s], [rad/s] Speed below which the robot is at rest. Upper bound: the arming checks' 0.05 rad/s.
REST_SPEED = 0.05
MAX_DROPS = 400  # measured: one drop in 4 to 30 succeeds, depending on robot and ground
# [rad] Largest tilt at rest; must be below the 25 degrees of the arming checks.
MAX_REST_TILT = np.radians(20.0)
# [rad] Tilt above which a drop is given up. Chosen: twice MAX_REST_TILT.
_ABORT_TILT = np.radians(40.0)
_DROP_TILT = np.radians(10.0)  # [rad] bound of the uniform draws of roll and pitch
_DROP_HEIGHT = 0.005  # [m] height of the lowest point above the ground: no bounce
_LEG_CLEARANCE = 0.02  # [m] smallest distance, along the body, from a front to a rear leg


def drop_robot(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    handles: Handles,
    robot: Robot,
    rng: np.random.Generator,
) -> None:
    """Place the robot just above the ground, with random attitude and random joint angles.

    Joint angles are uniform in the middle 94 % of each range, roll and pitch within 10 degrees, and
    the heading is arbitrary. Joint angles are drawn until legs_clear() is true.
    """
    lower, upper = np.array(robot.config.q_lower), np.array(robot.config.q_upper)
    mujoco.mj_resetData(model, data)
    while True:
        q = lower + (upper - lower) * rng.uniform(0.03, 0.97, 12)
        data.qpos[handles.joint_q] = data.qpos[handles.motor_q] = q
        data.qpos[:3] = [0.0, 0.0, 10.0]
        mujoco.mj_forward(model, data)
        if legs_clear(model, data, handles):
            break
    roll, pitch = rng.uniform(-_DROP_TILT, _DROP_TILT, 2)
    euler = np.array([roll, pitch, rng.uniform(-np.pi, np.pi)])
    mujoco.mju_euler2Quat(data.qpos[3:7], euler, "xyz")
    mujoco.mj_forward(model, data)
    data.qpos[2] -= _lowest_point(model, data) - _DROP_HEIGHT
    mujoco.mj_forward(model, data)
    mujoco.mj_step1(model, data)


def may_settle(model: mujoco.MjModel, data: mujoco.MjData, handles: Handles) -> bool:
    """Return whether the drop may succeed: tilt below 40 degrees, and legs_clear() is true."""
    tipped = data.xmat[handles.root, 8] < np.cos(_ABORT_TILT)
    return not tipped and legs_clear(model, data, handles)


def is_settled(model: mujoco.MjModel, data: mujoco.MjData, handles: Handles) -> bool:
    """Return whether the robot is at rest, within 20 degrees of level, with its legs clear."""
    level = data.xmat[handles.root, 8] > np.cos(MAX_REST_TILT)
    still = float(np.abs(data.qvel).max()) < REST_SPEED
    return bool(level and still and legs_clear(model, data, handles))


def legs_clear(model: mujoco.MjModel, data: mujoco.MjData, handles: Handles) -> bool:
    """Return whether links touch only the ground, and front legs are ahead of rear legs."""
    bodies = model.geom_bodyid[data.contact.geom]
    if np.any(np.all(bodies != 0, axis=1)):
        return False
    forward = data.xmat[handles.root].reshape(3, 3)[:, 0]
    calves = model.dof_bodyid[handles.joint_v[2::3]]
    reach: Array = np.stack([data.xpos[calves], data.xpos[handles.foot_bodies]]) @ forward
    front, rear = reach[:, :2].min(axis=0), reach[:, 2:].max(axis=0)
    return bool(np.all(front > rear + _LEG_CLEARANCE))


def _lowest_point(model: mujoco.MjModel, data: mujoco.MjData) -> float:
    robot_geoms = model.geom_bodyid != 0
    centre = data.geom_xpos[robot_geoms, 2]
    return float(np.min(centre - model.geom_rbound[robot_geoms]))
