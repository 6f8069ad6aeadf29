"""A hung robot: the base is fixed in the air, level, and the legs are free."""

from __future__ import annotations

import mujoco

from surefoot.geometry.rotations import Array
from surefoot.sim.model.mujoco_handles import Handles

CLEARANCE = 0.1  # [m] distance between the ground and the feet of straight legs; chosen
# The base keeps its free joint, because removing this joint would change all indices into qpos and
# qvel. A weld would act as a spring and cost solver time. Instead the base is heavy, and a damper
# that MuJoCo integrates implicitly holds the base: the weight of the legs moves the base by less
# than 1 um in ten minutes. A larger inertia without the damper loses solver precision: at 1e8 the
# leg accelerations become inexact, at 1e12 joint limits and collisions produce wrong leg motions.
# Found by trial. Test: the legs move as with a base that is welded to the world
# (test_plant_hanging.py).
_BASE_INERTIA = 1e6  # [kg], [kg.m^2]
_BASE_DAMPING = 1e12  # [N.s/m], [N.m.s]


def fix_base(model: mujoco.MjModel, handles: Handles) -> None:
    """Fix the base at any position that qpos sets.

    This changes the compiled model, because the solver's tolerances depend on the mean inertia at
    compile time and must not change.
    """
    start = int(model.body_dofadr[handles.root])
    model.dof_armature[start : start + 6] = _BASE_INERTIA
    model.dof_damping[start : start + 6] = _BASE_DAMPING


def hanging_height(model: mujoco.MjModel, data: mujoco.MjData, handles: Handles) -> float:
    """Return the height of the base at which straight legs clear flat ground [m].

    On return, `data` has straight legs and kinematics up to date.
    """
    data.qpos[handles.joint_q] = 0.0
    mujoco.mj_kinematics(model, data)
    feet: Array = data.xpos[handles.foot_bodies, 2]
    foot_depth = float(data.qpos[2] - feet.min()) + handles.foot_radius
    return foot_depth + CLEARANCE
