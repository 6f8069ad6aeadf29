# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import mujoco
import surefoot
from surefoot.sim import Plant

ROBOTS = ["a1", "go1", "go2", "b1"]


def pd_command(plant: Plant, kp: float = 5.0, kd: float = 0.2) -> surefoot.LowCmd:
    """Return a position-mode command for the standing pose; gains per kilogram of robot."""
    cmd, config, mass = surefoot.LowCmd(), plant.robot.config, plant.robot.mass
    for i, angle in enumerate(config.q_standing):
        motor = cmd.motorCmd[i]
        motor.q, motor.dq, motor.Kp, motor.Kd = angle, 0.0, kp * mass, kd * mass
    return cmd


def float_without_gravity(plant: Plant) -> None:
    """Lift the robot off the ground and switch gravity off."""
    plant.model.opt.gravity[:] = 0.0
    plant.data.qpos[2] += 1.0
    plant.data.qvel[:] = 0.0
    mujoco.mj_step1(plant.model, plant.data)  # Plant.step() begins with mj_step2
