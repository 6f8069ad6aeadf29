# SPDX-License-Identifier: BSD-3-Clause
"""A walking robot learns the rotor inertia and the friction of its joints."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from surefoot import WalkController, WalkVelocity
from surefoot.sim import Plant
from surefoot.walk.settings import walking_plant

pytestmark = pytest.mark.slow


def walked(seconds: float = 5.0, **settings: Any) -> tuple[Plant, WalkController]:
    """Return a go1 and its controller after half a second of standing and a trot at 0.4 m/s."""
    plant = Plant("go1", replace(walking_plant(), **settings))
    controller = WalkController(plant.robot)
    state = plant.reset()
    for k in range(round(500 * seconds)):
        if k > 250:
            controller.set_velocity(WalkVelocity(0.4, 0.0, 0.0))
        state = plant.step(controller.update(state))
    return plant, controller


@pytest.mark.parametrize("scale", [0.5, 2.0])
def test_walk_without_foot_forces_learns_the_rotor_inertia(scale: float) -> None:
    plant, controller = walked(foot_force="dead", armature_scale=scale)
    assert not plant.truth.fell
    learnt = controller.estimator_report.armature / plant.robot.config.armature
    assert np.all(np.abs(learnt - scale) < 0.25)


def test_walk_learns_the_friction_of_the_joints() -> None:
    plant, controller = walked(joint_friction_scale=5.0)
    report = controller.estimator_report
    swing_speed = 4.0  # [rad/s]
    truth = 5.0 * (0.2 + 0.01 * swing_speed)  # models/go1.toml
    learnt = report.joint_friction + report.joint_damping * swing_speed
    assert not plant.truth.fell
    assert np.all(np.abs(learnt / truth - 1.0) < 0.3)


def test_robot_that_stands_learns_nothing() -> None:
    plant, controller = walked(0.4, armature_scale=2.0)
    report = controller.estimator_report
    assert np.array_equal(report.armature, plant.robot.config.armature)
    assert not np.any(report.joint_friction) and not np.any(report.joint_damping)
