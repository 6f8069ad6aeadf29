# SPDX-License-Identifier: BSD-3-Clause
"""A go1 learns the friction of the floor from its feet, while standing and while walking."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from surefoot import Gait, StandController
from surefoot.sim import Plant, PlantSettings, Push
from surefoot.stand import parse_push
from surefoot.walk import WalkLog, WalkSettings, parse_velocity, run_walk

pytestmark = pytest.mark.slow


def run(friction: float, **settings) -> WalkLog:
    walk = WalkSettings(**settings)
    return run_walk(replace(walk, plant=replace(walk.plant, friction=friction)))


# On a floor of 0.4, a push of 60 % makes a foot slide by 1 mm only, which teaches less.
@pytest.mark.parametrize(("friction", "percent"), [(0.2, 60), (0.3, 60), (0.4, 80)])
def test_one_push_on_a_slippery_floor_teaches_its_friction(friction: float, percent: int) -> None:
    log = run(friction, duration=2.5, pushes=(parse_push(f"lateral:{percent}%:0.1@1.0"),))
    assert not log.fell
    assert log.friction[int(0.9 * 500)] == log.robot.config.friction
    assert log.friction[-1] == pytest.approx(friction, abs=0.08)


def test_a_few_strides_on_a_floor_of_0_4_teach_its_friction() -> None:
    log = run(0.4, duration=3.5, gait=Gait.TROT, velocities=(parse_velocity("0.5,0,0@0.5"),))
    assert not log.fell
    assert log.friction[-1] == pytest.approx(0.4, abs=0.08)


def test_push_and_walk_on_a_good_floor_keep_the_assumed_friction() -> None:
    pushes = (parse_push("lateral:60%:0.1@1.0"),)
    log = run(0.8, duration=4.0, pushes=pushes, velocities=(parse_velocity("0.5,0,0@2.0"),))
    assert not log.fell
    assert log.friction.min() >= 0.55


# All feet slide together to the left. The velocity from the IMU must outweigh theirs: with feet
# that drag the estimate along, its error was 0.25 m/s.
@pytest.mark.parametrize("robot", ["go1", "b1"])
def test_velocity_stays_right_while_all_feet_slide(robot: str) -> None:
    plant = Plant(robot, PlantSettings(seed=1, friction=0.4, physics_dt=0.001))
    plant.reseed(1, [Push(90.0, 0.6 * plant.lip_push_limit("lateral"), 0.1, 0.5)])
    controller, state = StandController(plant.robot), plant.reset()
    errors = []
    for _ in range(500):
        state = plant.step(controller.update(state))
        errors.append(np.linalg.norm(controller.state.v[:2] - plant.truth.v[:2]))
    assert not plant.truth.fell
    assert max(errors[250:]) < 0.12


# A blow of 1 ms falls between two samples of the IMU, so only the feet show the new velocity.
@pytest.mark.parametrize("direction", [0.0, 90.0, 200.0])
def test_velocity_is_right_40_ms_after_a_blow_that_the_imu_missed(direction: float) -> None:
    plant = Plant("go1", PlantSettings(seed=1, physics_dt=0.001))
    plant.reseed(1, [Push(direction, 0.35 * plant.robot.mass, 0.001, 0.5)])
    controller, state = StandController(plant.robot), plant.reset()
    for tick in range(400):
        state = plant.step(controller.update(state))
        error = np.linalg.norm(controller.state.v[:3] - plant.truth.v[:3])
        assert tick < 270 or error < 0.06, tick
