# SPDX-License-Identifier: BSD-3-Clause
"""A motor fails while the robot stands: it stands on three legs, or comes down slowly."""

from __future__ import annotations

import numpy as np
import pytest
import surefoot
from monitored_robot import MonitoredRobot
from surefoot import FaultId, Mode, RequestStatus, Start
from surefoot.faults.kinds.motor_faults import OVERHEATED_MODE, DeadMotor
from surefoot.faults.matrix.verdict import allowed_descent_speed
from surefoot.robot.power_level import power_level
from surefoot.sim import Plant, PlantSettings

pytestmark = pytest.mark.slow

SERVO = 0x0A  # mode of a working motor


class Standing:
    """A standing robot whose motors can fail."""

    def __init__(self, robot: str, lean: tuple[float, float] = (0.0, 0.0)) -> None:
        self.plant = Plant(robot, PlantSettings(seed=1))
        options = surefoot.SupervisorOptions(power_level=power_level(robot), start=Start.STANDING)
        self.supervisor = surefoot.Supervisor(self.plant.robot, options=options)
        self.dead: list[DeadMotor | SilentLeg] = []
        self.max_sinking_speed = 0.0  # [m/s] largest
        self.state = self.plant.reset()
        self.run_for(0.1)
        self.supervisor.set_body_reference(surefoot.BodyReference(*lean, 0.0, 0.0, 0.0, 0.0))
        self.run_for(2.0)
        self.height = self.plant.truth.q[2]

    def run_for(self, seconds: float) -> None:
        for _ in range(round(seconds / 0.002)):
            command = self.supervisor.update(self.state)
            for dead in self.dead:
                dead.change_command(command, 0)
            self.state = self.plant.step(command)
            for dead in self.dead:
                dead.change_state(self.state, 0)
            self.max_sinking_speed = max(self.max_sinking_speed, -self.plant.truth.v[2])

    def kill_motor(self, motor: int, reported_mode: int = OVERHEATED_MODE) -> None:
        self.dead.append(DeadMotor(motor, reported_mode))

    def sinking_distance(self) -> float:
        return float(self.height - self.plant.truth.q[2])

    def has(self, fault: FaultId) -> bool:
        return fault in self.supervisor.faults.active


@pytest.mark.parametrize("motor", [0, 4, 5])  # FR hip, FL thigh, FL knee
@pytest.mark.parametrize("robot", ["a1", "go1", "go2", "b1"])
def test_robot_with_a_dead_motor_stands_on_three_legs(robot: str, motor: int) -> None:
    scene = Standing(robot)
    scene.kill_motor(motor)
    scene.run_for(4.0)
    assert scene.supervisor.mode == Mode.STAND
    assert scene.has(FaultId.LEG_LOST) and not scene.has(FaultId.MOTOR_MODE)
    assert scene.supervisor.controller.lost_leg == motor // 3
    assert scene.supervisor.faults.motor(FaultId.LEG_LOST) == motor
    assert abs(scene.sinking_distance()) < 0.03
    assert np.abs(scene.plant.truth.v[:6]).max() < 0.03
    others = [leg for leg in range(4) if leg != motor // 3]
    assert scene.plant.truth.contact[others].all()
    assert scene.supervisor.controller.capture_margin_without(motor // 3) > 0.02


class SilentLeg:
    """A leg whose bus has failed: it gets no commands, and its joint samples are frozen."""

    def __init__(self, leg: int) -> None:
        self.joints = range(3 * leg, 3 * leg + 3)
        self.last: list[tuple[float, float]] = []

    def change_command(self, command: surefoot.LowCmd, k: int) -> None:
        for i in self.joints:
            motor = command.motorCmd[i]
            motor.tau = motor.Kp = motor.Kd = 0.0

    def change_state(self, state: surefoot.LowState, k: int) -> None:
        motors = [state.motorState[i] for i in self.joints]
        self.last = self.last or [(motor.q, 0.3) for motor in motors]
        for motor, (q, dq) in zip(motors, self.last, strict=True):
            motor.mode, motor.tauEst = OVERHEATED_MODE, 0.0
            motor.q, motor.dq = q, dq


@pytest.mark.parametrize("robot", ["a1", "go1", "go2", "b1"])
def test_lost_leg_needs_no_valid_joint_samples(robot: str) -> None:
    scene = Standing(robot)
    silent = SilentLeg(1)
    scene.dead.append(silent)
    scene.run_for(3.0)
    assert scene.supervisor.mode == Mode.STAND
    assert scene.has(FaultId.LEG_LOST) and not scene.has(FaultId.ENCODER)
    hip = float(scene.plant.robot.config.q_upper[3]) + 0.2
    silent.last[0] = (hip, 0.3)
    scene.run_for(0.5)
    assert scene.supervisor.mode == Mode.STAND
    assert not scene.has(FaultId.JOINT_STOP)
    assert abs(scene.sinking_distance()) < 0.03


@pytest.mark.parametrize(("robot", "motor"), [("a1", 5), ("go1", 8), ("go2", 8), ("b1", 5)])
def test_dead_motor_in_servo_mode_is_detected_by_its_torque(robot: str, motor: int) -> None:
    scene = Standing(robot)
    scene.kill_motor(motor, reported_mode=SERVO)  # a calf, FL or RR
    scene.run_for(0.2)
    assert scene.has(FaultId.LEG_LOST)
    assert scene.supervisor.faults.motor(FaultId.LEG_LOST) == motor
    scene.run_for(3.0)
    assert scene.supervisor.mode == Mode.STAND
    assert abs(scene.sinking_distance()) < 0.03


def test_support_margin_is_nan_for_invalid_legs_and_inf_after_a_loss() -> None:
    stand = surefoot.StandController(surefoot.load_robot("go1"))
    assert np.isnan(stand.capture_margin_without(0))  # no sample yet
    scene = Standing("go1")
    stand = scene.supervisor.controller
    assert all(np.isnan(stand.capture_margin_without(leg)) for leg in (-1, 4))
    assert all(abs(stand.capture_margin_without(leg)) < 0.05 for leg in range(4))
    stand.declare_leg_lost(7)
    assert stand.lost_leg == -1
    stand.declare_leg_lost(2)
    stand.declare_leg_lost(1)
    assert stand.lost_leg == 2
    assert stand.capture_margin_without(1) == np.inf
    scene.run_for(0.1)
    assert scene.has(FaultId.LEG_LOST)  # also after declare_leg_lost()
    assert scene.supervisor.faults.motor(FaultId.LEG_LOST) == 6


def test_lost_leg_gets_damping_without_torque() -> None:
    scene = Standing("go1")
    scene.kill_motor(5)
    scene.run_for(1.0)
    command = scene.supervisor.update(scene.state)
    for i in range(12):
        lost = i // 3 == 1
        assert (command.motorCmd[i].Kd > 0.0) == lost
        assert (command.motorCmd[i].tau == 0.0) == lost


@pytest.mark.parametrize("robot", ["a1", "go1", "go2", "b1"])
def test_robot_leaning_on_the_dead_leg_comes_down_slowly(robot: str) -> None:
    scene = Standing(robot, lean=(-0.03, 0.02))  # to the rear left
    assert scene.supervisor.controller.capture_margin_without(3) < -0.02
    scene.kill_motor(11)
    scene.run_for(2.0)
    assert scene.supervisor.mode == Mode.DAMPING
    assert scene.supervisor.damping_fault == FaultId.MOTOR_MODE
    assert scene.max_sinking_speed < allowed_descent_speed(scene.height)


def test_second_dead_motor_damps_the_robot() -> None:
    scene = Standing("go1")
    scene.kill_motor(5)
    scene.run_for(2.0)
    scene.kill_motor(6)
    scene.run_for(0.1)
    assert scene.supervisor.mode == Mode.DAMPING
    assert scene.supervisor.damping_fault == FaultId.MOTOR_MODE


def test_three_legged_robot_sits_down_on_request_and_latches() -> None:
    scene = Standing("go1")
    scene.kill_motor(5)
    scene.run_for(2.0)
    scene.max_sinking_speed = 0.0
    scene.supervisor.request(Mode.SIT)
    scene.run_for(6.0)
    assert scene.supervisor.mode == Mode.DAMPING
    assert scene.max_sinking_speed < 1.2
    assert scene.sinking_distance() > 0.5 * scene.height
    assert scene.supervisor.request(Mode.RISE) == RequestStatus.LATCHED


def test_recovered_motor_does_not_restore_the_leg() -> None:
    scene = Standing("go1")
    scene.kill_motor(5)
    scene.run_for(1.0)
    scene.dead.clear()
    scene.run_for(1.0)
    assert scene.supervisor.mode == Mode.STAND
    assert scene.has(FaultId.LEG_LOST)
    assert scene.supervisor.controller.lost_leg == 1


def test_repaired_robot_can_be_armed_and_rises_on_four_legs() -> None:
    robot = MonitoredRobot("go1", 1)
    robot.arm()
    robot.request(Mode.RISE)
    assert robot.reaches(Mode.STAND, 12.0)
    robot.run(1.0)
    robot.faults = [DeadMotor(5, OVERHEATED_MODE)]
    robot.run(1.0)
    assert robot.supervisor.controller.lost_leg == 1
    robot.request(Mode.SIT)
    assert robot.reaches(Mode.DAMPING, 8.0)
    robot.run(2.0)
    assert not robot.supervisor.arming.ready
    assert robot.supervisor.arm() == RequestStatus.NOT_READY
    robot.faults = []
    robot.arm()
    assert robot.supervisor.controller.lost_leg == -1
    assert FaultId.LEG_LOST not in robot.supervisor.faults.active
    robot.request(Mode.RISE)
    assert robot.reaches(Mode.STAND, 12.0)
    robot.run(1.0)
    assert robot.plant.truth.contact.all()
