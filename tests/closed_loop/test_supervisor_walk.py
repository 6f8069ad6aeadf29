# SPDX-License-Identifier: BSD-3-Clause
"""Supervised robots walk with walking sensors: no false fault, real faults, sitting down."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
import surefoot
from surefoot import FaultId, Mode, RequestStatus, Start, SupervisorOptions, WalkVelocity
from surefoot.faults.matrix.scenario import WALKING_LEVEL
from surefoot.sim import Lift, Plant, PlantSettings, Push

pytestmark = pytest.mark.slow

PERIOD = 0.002  # [s]
STOP_TIME = 1.5  # [s] in which a walking robot stops: kStopTime (supervisor_walk.cpp)
FORWARD = WalkVelocity(0.5, 0.0, 0.0)


class WalkingRobot:
    """A supervised robot that is taken over standing and requested to walk."""

    def __init__(self, name: str = "go1", level: int = WALKING_LEVEL) -> None:
        settings = PlantSettings(
            walking_sensors=True, soft_soles=True, leg_collisions=True, physics_dt=0.001, seed=1
        )
        self.plant = Plant(name, settings)
        options = SupervisorOptions(power_level=level, start=Start.STANDING)
        self.supervisor = surefoot.Supervisor(self.plant.robot, options=options)
        self.state = self.plant.reset()
        self.run(0.6, None)
        assert self.supervisor.request(Mode.WALK) == RequestStatus.ACCEPTED

    def run(
        self,
        seconds: float,
        velocity: WalkVelocity | None,
        until: Callable[[], bool] = lambda: False,
    ) -> float:
        """Run until a condition is true; return the time [s]."""
        for k in range(round(seconds / PERIOD)):
            if until():
                return k * PERIOD
            if velocity is not None:
                self.supervisor.set_velocity(velocity)
            self.state = self.plant.step(self.supervisor.update(self.state))
        return seconds

    def faults(self) -> list[str]:
        report = self.supervisor.faults
        return [info.name for info in surefoot.fault_table() if report.count(info.id)]


def test_walking_turning_and_a_push_of_half_of_the_limit_cause_no_fault() -> None:
    robot = WalkingRobot()
    robot.run(2.0, FORWARD)
    impulse = 0.5 * robot.plant.lip_push_limit("lateral", 0.1)
    robot.plant.add_push(Push("lateral", impulse, 0.1, robot.plant.time))
    robot.run(2.0, FORWARD)
    robot.run(2.0, WalkVelocity(0.2, 0.1, 1.5))
    robot.run(1.5, WalkVelocity())
    assert robot.faults() == []
    assert robot.supervisor.mode == Mode.WALK
    assert not robot.supervisor.controller.walking
    assert not robot.plant.truth.fell


def test_robot_at_half_a_metre_per_second_sits_down_within_the_stop_time_and_the_descent() -> None:
    robot = WalkingRobot()
    robot.run(2.0, FORWARD)
    supervisor = robot.supervisor
    assert supervisor.controller.state.v[0] > 0.4
    assert supervisor.request(Mode.SIT) == RequestStatus.ACCEPTED
    stopped = robot.run(3.0, FORWARD, lambda: supervisor.mode == Mode.SIT)
    assert stopped <= STOP_TIME
    assert np.linalg.norm(robot.plant.truth.com_velocity[:2]) < 0.1
    lay = robot.run(5.0, FORWARD, lambda: supervisor.mode == Mode.PASSIVE)
    assert lay < supervisor.rise_time + 1.0
    assert robot.faults() == []


def test_last_step_of_a_b1_before_it_stands_is_no_fault() -> None:
    robot = WalkingRobot("b1", 10)
    robot.run(1.33, FORWARD)
    assert robot.supervisor.request(Mode.STAND) == RequestStatus.ACCEPTED
    robot.run(3.0, FORWARD, lambda: robot.supervisor.mode == Mode.STAND)
    assert robot.supervisor.mode == Mode.STAND
    robot.run(0.1, None)
    assert robot.faults() == []


def test_lifted_robot_stops_walking_and_must_be_requested_to_walk_again() -> None:
    robot = WalkingRobot()
    robot.run(1.5, FORWARD)
    robot.plant.add_lift(Lift("trunk", robot.plant.time, 1.0, 0.2, ramp=0.3))
    robot.run(0.9, FORWARD)
    assert robot.supervisor.faults.count(FaultId.LIFTED) == 1
    assert robot.supervisor.mode == Mode.STAND
    assert robot.supervisor.request(Mode.WALK) == RequestStatus.NOT_READY
    robot.run(1.5, FORWARD)
    assert robot.supervisor.mode == Mode.STAND
    assert robot.supervisor.request(Mode.WALK) == RequestStatus.ACCEPTED
