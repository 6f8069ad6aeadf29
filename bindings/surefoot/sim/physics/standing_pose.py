"""Start of a run: the standing pose, on the ground or hung, held in position mode."""

from __future__ import annotations

import mujoco
import numpy as np

from surefoot._core import Robot
from surefoot.sim.hardware.motors import MotorLaw, hold_law
from surefoot.sim.model.mujoco_handles import Handles
from surefoot.sim.physics.hanging import hanging_height
from surefoot.sim.settings import PlantSettings

# Chosen by hand; test: test_feet_of_a_position_controlled_robot_creep_below_0_1_mm.
# [s] Time in position mode before the first LowState: 25 time constants HOLD_KD / HOLD_KP.
SETTLE_TIME = 0.8
HOLD_KP = 25.0  # [N.m/rad] stiffness per kilogram of robot: calves sag by about one degree
HOLD_KD = 0.8  # [N.m.s/rad] damping per kilogram of robot: the legs settle without swinging


def place_standing(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    handles: Handles,
    robot: Robot,
    settings: PlantSettings,
) -> None:
    """Reset to the standing pose: hung, or on the ground and parallel to it.

    On soft ground and on soft soles, the lowest foot penetrates by settings.contact_sink.
    """
    mujoco.mj_resetData(model, data)
    data.qpos[3:7] = model.geom_quat[handles.ground_geom]
    if settings.hung:
        data.qpos[2] = hanging_height(model, data, handles)
    data.qpos[handles.joint_q] = robot.config.q_standing
    data.qpos[handles.motor_q] = robot.config.q_standing  # with backlash: in the middle of the play
    if settings.hung:
        return
    mujoco.mj_kinematics(model, data)
    heights = data.xpos[handles.foot_bodies] @ handles.ground_normal
    gap = heights.min() - handles.foot_radius + settings.contact_sink
    data.qpos[:3] -= gap * handles.ground_normal


def standing_law(robot: Robot) -> MotorLaw:
    """Return the law that holds the standing pose in position mode."""
    q = np.array(robot.config.q_standing)
    return hold_law(q, HOLD_KP * robot.mass, HOLD_KD * robot.mass)
