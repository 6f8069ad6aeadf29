# SPDX-License-Identifier: BSD-3-Clause
"""Simulation of a standing robot after a short push: does it come to rest?"""

from __future__ import annotations

import functools

import numpy as np
from surefoot import Gains, StandController
from surefoot.robot.description import describe_robot
from surefoot.sim import Plant, PlantSettings
from surefoot.tune.design import AXES, Direction, Goal, StandingBody, compute_standing_body

DIRECTION_NAMES = ("x", "y", "z", "roll", "pitch", "yaw")
GOAL = Goal(2.0, 0.8)  # of every axis; the gains of one axis get a factor
PUSH_TIME, PUSH_DURATION, RUN_TIME = 0.6, 0.01, 2.6  # [s]
REST_TIME = 0.6  # [s] final time in which the robot must be at rest
MAX_REST_RMS = np.array(
    [0.15, 0.15, 0.15, 1.0, 1.0, 1.0]
)  # [m/s^2, rad/s^2] RMS at rest; noise is 0.02 and 0.1


@functools.cache
def body_of(robot: str) -> StandingBody:
    return compute_standing_body(describe_robot(robot))


@functools.cache
def plant_of(robot: str, delay: float, friction: float) -> Plant:
    return Plant(robot, PlantSettings(extra_delay=delay, joint_friction_scale=friction, seed=1))


def gains_with_factor(robot: str, axis: str, factor: float) -> Gains:
    """Return gains for GOAL on all axes, with a factor on kp and kd of one axis."""
    gains = body_of(robot).robot.config.gains
    for name, (kp, kd, _) in AXES.items():
        times = factor if name == axis else 1.0
        setattr(gains, kp, times * GOAL.kp)
        setattr(gains, kd, times * GOAL.kd)
    return gains


def comes_to_rest(
    robot: str, delay: float, gains: Gains, direction: Direction, friction: float = 1.0
) -> bool:
    """Push a standing robot; return whether all six accelerations are small at the end.

    A fall counts as not at rest.

    Args:
        robot: Name of the robot.
        delay: Further delay of the commands [s].
        gains: Gains of the controller.
        direction: Direction of the push.
        friction: Factor on the joint friction.
    """
    plant = plant_of(robot, delay, friction)
    controller = StandController(plant.robot, gains)
    state = plant.reset()
    root = plant.handles.root
    rate = plant.settings.control_rate
    first, last = round(PUSH_TIME * rate), round((PUSH_TIME + PUSH_DURATION) * rate)
    wrench = np.zeros(6)
    wrench[DIRECTION_NAMES.index(direction.name)] = (
        direction.inertia * direction.push_velocity / PUSH_DURATION
    )
    speeds = np.zeros((round(RUN_TIME * rate), 6))
    for k in range(len(speeds)):
        plant.data.xfrc_applied[root] = 0.0
        if first <= k < last:
            arm = plant.data.subtree_com[root] - plant.data.xipos[root]
            plant.data.xfrc_applied[root] = wrench
            plant.data.xfrc_applied[root, 3:] += np.cross(arm, wrench[:3])
        state = plant.step(controller.update(state))
        speeds[k] = plant.data.qvel[:6]
        if plant.truth.fell:
            break
    plant.data.xfrc_applied[root] = 0.0
    if plant.truth.fell:
        return False
    a = rate * np.diff(speeds[-round(REST_TIME * rate) :], axis=0)
    return bool(np.all(np.sqrt(np.mean(a**2, axis=0)) < MAX_REST_RMS))
