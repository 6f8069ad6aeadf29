# SPDX-License-Identifier: BSD-3-Clause
"""A motor dies while the robot stands: on three feet it goes on, or it comes down slowly."""

from __future__ import annotations

import numpy as np
import pytest
import surefoot
from get_up_helpers import Watched
from surefoot import FaultId, Mode, RequestStatus, Start
from surefoot.faults.joint_faults import power_level
from surefoot.faults.motor_faults import OVERHEATED, Dead
from surefoot.faults.verdict import fall_speed
from surefoot.sim import Plant, PlantSettings

SERVO = 0x0A  # the mode of a motor that works


class Standing:
    """A robot that has stood for a second, and whose motors may die."""

    def __init__(self, robot: str, lean: tuple[float, float] = (0.0, 0.0)) -> None:
        self.plant = Plant(robot, PlantSettings(seed=1))
        options = surefoot.SupervisorOptions(power_level=power_level(robot), start=Start.STANDING)
        self.supervisor = surefoot.Supervisor(self.plant.robot, options=options)
        self.dead: list[Dead | Silent] = []
        self.sinking = 0.0  # [m/s] greatest
        self.state = self.plant.reset()
        self.go_on(0.1)
        self.supervisor.set_body_reference(surefoot.BodyReference(*lean, 0.0, 0.0, 0.0, 0.0))
        self.go_on(2.0)
        self.height = self.plant.truth.q[2]

    def go_on(self, seconds: float) -> None:
        for _ in range(round(seconds / 0.002)):
            command = self.supervisor.update(self.state)
            for dead in self.dead:
                dead.command(command, 0)
            self.state = self.plant.step(command)
            for dead in self.dead:
                dead.state(self.state, 0)
            self.sinking = max(self.sinking, -self.plant.truth.v[2])

    def die(self, motor: int, says: int = OVERHEATED) -> None:
        self.dead.append(Dead(motor, says))

    def sunk(self) -> float:
        return float(self.height - self.plant.truth.q[2])

    def has(self, fault: FaultId) -> bool:
        return fault in self.supervisor.faults.active


@pytest.mark.parametrize("motor", [0, 4, 5])  # FR hip, FL thigh, FL knee
@pytest.mark.parametrize("robot", ["a1", "go1", "go2", "b1"])
def test_a_robot_whose_motor_died_stands_on_three_legs(robot: str, motor: int) -> None:
    scene = Standing(robot)
    scene.die(motor)
    scene.go_on(4.0)
    assert scene.supervisor.mode == Mode.STAND
    assert scene.has(FaultId.LEG_LOST) and not scene.has(FaultId.MOTOR_MODE)
    assert scene.supervisor.stand.lost_leg == motor // 3
    assert scene.supervisor.faults.motor(FaultId.LEG_LOST) == motor
    assert abs(scene.sunk()) < 0.03
    assert np.abs(scene.plant.truth.v[:6]).max() < 0.03
    others = [leg for leg in range(4) if leg != motor // 3]
    assert scene.plant.truth.contact[others].all()
    assert scene.supervisor.stand.margin_without(motor // 3) > 0.02


class Silent:
    """A leg whose bus has died: it gets no command, and its report is the last one for good."""

    def __init__(self, leg: int) -> None:
        self.joints = range(3 * leg, 3 * leg + 3)
        self.last: list[tuple[float, float]] = []

    def command(self, command: surefoot.LowCmd, k: int) -> None:
        for i in self.joints:
            motor = command.motorCmd[i]
            motor.tau = motor.Kp = motor.Kd = 0.0

    def state(self, state: surefoot.LowState, k: int) -> None:
        motors = [state.motorState[i] for i in self.joints]
        self.last = self.last or [(motor.q, 0.3) for motor in motors]
        for motor, (q, dq) in zip(motors, self.last, strict=True):
            motor.mode, motor.tauEst = OVERHEATED, 0.0
            motor.q, motor.dq = q, dq


@pytest.mark.parametrize("robot", ["a1", "go1", "go2", "b1"])
def test_of_a_leg_that_was_given_up_no_report_is_expected(robot: str) -> None:
    scene = Standing(robot)
    silent = Silent(1)
    scene.dead.append(silent)
    scene.go_on(3.0)
    assert scene.supervisor.mode == Mode.STAND
    assert scene.has(FaultId.LEG_LOST) and not scene.has(FaultId.ENCODER)
    hip = float(scene.plant.robot.config.q_upper[3]) + 0.2
    silent.last[0] = (hip, 0.3)
    scene.go_on(0.5)
    assert scene.supervisor.mode == Mode.STAND
    assert not scene.has(FaultId.JOINT_STOP)
    assert abs(scene.sunk()) < 0.03


@pytest.mark.parametrize(("robot", "motor"), [("a1", 5), ("go1", 8), ("go2", 8), ("b1", 5)])
def test_a_motor_that_sleeps_and_denies_it_is_found_by_its_torque(robot: str, motor: int) -> None:
    scene = Standing(robot)
    scene.die(motor, says=SERVO)  # a calf, FL or RR
    scene.go_on(0.2)
    assert scene.has(FaultId.LEG_LOST)
    assert scene.supervisor.faults.motor(FaultId.LEG_LOST) == motor
    scene.go_on(3.0)
    assert scene.supervisor.mode == Mode.STAND
    assert abs(scene.sunk()) < 0.03


def test_margins_of_legs_that_are_none_or_lost_are_no_promise() -> None:
    stand = surefoot.StandController(surefoot.load_robot("go1"))
    assert np.isnan(stand.margin_without(0))  # no report yet
    scene = Standing("go1")
    stand = scene.supervisor.stand
    assert all(np.isnan(stand.margin_without(leg)) for leg in (-1, 4))
    assert all(abs(stand.margin_without(leg)) < 0.05 for leg in range(4))
    stand.give_up(7)
    assert stand.lost_leg == -1
    stand.give_up(2)
    stand.give_up(1)
    assert stand.lost_leg == 2
    assert stand.margin_without(1) == np.inf
    scene.go_on(0.1)
    assert scene.has(FaultId.LEG_LOST)  # whoever gave it up
    assert scene.supervisor.faults.motor(FaultId.LEG_LOST) == 6


def test_the_leg_that_is_given_up_gets_no_torques_and_damps() -> None:
    scene = Standing("go1")
    scene.die(5)
    scene.go_on(1.0)
    command = scene.supervisor.update(scene.state)
    for i in range(12):
        lost = i // 3 == 1
        assert (command.motorCmd[i].Kd > 0.0) == lost
        assert (command.motorCmd[i].tau == 0.0) == lost


@pytest.mark.parametrize("robot", ["a1", "go1", "go2", "b1"])
def test_where_the_weight_is_over_the_dying_leg_it_comes_down_slowly(robot: str) -> None:
    scene = Standing(robot, lean=(-0.03, 0.02))  # to the rear left
    assert scene.supervisor.stand.margin_without(3) < -0.02
    scene.die(11)
    scene.go_on(2.0)
    assert scene.supervisor.mode == Mode.DAMPING
    assert scene.supervisor.reason == FaultId.MOTOR_MODE
    assert scene.sinking < fall_speed(scene.height)


def test_a_second_leg_is_not_given_up() -> None:
    scene = Standing("go1")
    scene.die(5)
    scene.go_on(2.0)
    scene.die(6)
    scene.go_on(0.1)
    assert scene.supervisor.mode == Mode.DAMPING
    assert scene.supervisor.reason == FaultId.MOTOR_MODE


def test_on_three_legs_it_lies_down_when_asked_and_does_not_get_up_again() -> None:
    scene = Standing("go1")
    scene.die(5)
    scene.go_on(2.0)
    scene.sinking = 0.0
    scene.supervisor.request(Mode.SIT)
    scene.go_on(6.0)
    assert scene.supervisor.mode == Mode.DAMPING
    assert scene.sinking < 1.2
    assert scene.sunk() > 0.5 * scene.height
    assert scene.supervisor.request(Mode.RISE) == RequestStatus.LATCHED


def test_a_motor_that_recovers_does_not_bring_the_leg_back() -> None:
    scene = Standing("go1")
    scene.die(5)
    scene.go_on(1.0)
    scene.dead.clear()
    scene.go_on(1.0)
    assert scene.supervisor.mode == Mode.STAND
    assert scene.has(FaultId.LEG_LOST)
    assert scene.supervisor.stand.lost_leg == 1


def test_once_the_motor_is_repaired_it_can_be_armed_and_gets_up_on_four_legs() -> None:
    robot = Watched("go1", 1)
    robot.arm()
    robot.ask(Mode.RISE)
    assert robot.reaches(Mode.STAND, 12.0)
    robot.run(1.0)
    robot.faults = [Dead(5, OVERHEATED)]
    robot.run(1.0)
    assert robot.supervisor.stand.lost_leg == 1
    robot.ask(Mode.SIT)
    assert robot.reaches(Mode.DAMPING, 8.0)
    robot.run(2.0)
    assert not robot.supervisor.arming.ready
    assert robot.supervisor.arm() == RequestStatus.NOT_READY
    robot.faults = []
    robot.arm()
    assert robot.supervisor.stand.lost_leg == -1
    assert FaultId.LEG_LOST not in robot.supervisor.faults.active
    robot.ask(Mode.RISE)
    assert robot.reaches(Mode.STAND, 12.0)
    robot.run(1.0)
    assert robot.plant.truth.contact.all()
