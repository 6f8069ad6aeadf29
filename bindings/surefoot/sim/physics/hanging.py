"""A robot hung up: its base fixed in the air, level, its legs free."""

from __future__ import annotations

import mujoco

from surefoot._core import Robot
from surefoot.geometry.rotations import Array
from surefoot.sim.model.mujoco_handles import Handles

CLEARANCE = 0.1  # [m] below the feet of straight legs
# A base without its free joint would change what every index into qpos and qvel means; a weld would
# be a spring and cost solver time. So it is heavy, and held by a damper that MuJoCo treats
# implicitly: the legs' weight moves it by less than 1 um in ten minutes. More inertia instead of
# the damper costs the solver its digits: at 1e8 it begins to miss the legs' accelerations, at 1e12
# joint limits and collisions throw legs about.
_BASE_INERTIA = 1e6  # [kg], [kg.m^2]
_BASE_DAMPING = 1e12  # [N.s/m], [N.m.s]


def fix_base(model: mujoco.MjModel, handles: Handles) -> None:
    """Fix the base wherever it is put.

    It is done to the compiled model because the solver's tolerances, which come from the robot's
    mean inertia, must not change.
    """
    start = int(model.body_dofadr[handles.root])
    model.dof_armature[start : start + 6] = _BASE_INERTIA
    model.dof_damping[start : start + 6] = _BASE_DAMPING


def hanging_height(
    model: mujoco.MjModel, data: mujoco.MjData, handles: Handles, robot: Robot
) -> float:
    """Return the height of the base at which straight legs clear flat ground [m].

    Leaves `data` with straight legs, its kinematics up to date.
    """
    data.qpos[handles.joint_q] = 0.0
    mujoco.mj_kinematics(model, data)
    feet: Array = data.xpos[handles.foot_bodies, 2]
    foot_depth = float(data.qpos[2] - feet.min()) + robot.config.foot_radius
    return foot_depth + CLEARANCE
