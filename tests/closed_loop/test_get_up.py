# SPDX-License-Identifier: BSD-3-Clause
"""Getting up, standing and lying down within the power level."""

from __future__ import annotations

import threading

import numpy as np
import pytest
import surefoot
from monitored_robot import MonitoredRobot, is_damping
from plant_helpers import ROBOTS
from surefoot import FaultId, Mode, RequestStatus
from surefoot.robot.power_level import power_level

pytestmark = pytest.mark.slow


def standing_robot(name: str, seed: int) -> MonitoredRobot:
    robot = MonitoredRobot(name, seed)
    robot.arm()
    robot.request(Mode.RISE)
    assert robot.reaches(Mode.STAND, 12.0), (robot.supervisor.mode, robot.supervisor.damping_fault)
    return robot


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("name", ROBOTS)
def test_lying_robot_gets_up_stands_and_lies_down_within_the_power_level(
    name: str, seed: int
) -> None:
    robot = standing_robot(name, seed)
    robot.run(1.5)
    truth = robot.plant.truth
    assert not truth.fell
    assert robot.supervisor.controller.status == surefoot.Status.OK
    assert np.abs(truth.v).max() < 0.05
    assert np.abs(robot.plant.data.qpos[7:] - robot.plant.robot.q_standing()[7:]).max() < 0.2
    robot.request(Mode.SIT)
    assert robot.reaches(Mode.PASSIVE, 8.0)
    robot.run(1.0)
    assert is_damping(robot.command)
    assert np.abs(robot.plant.truth.v[:6]).max() < 0.05  # the knees may still sink, damped
    assert robot.protection_trips == 0
    assert robot.power < 2.0 * 100.0 * power_level(name)  # for fewer than six samples
    assert robot.torque_step_at_mode_change < 0.05
    assert robot.max_torque_step < 0.3


# Lying poses with leg interference: a foot on the trunk; hips turned inward with thighs across the
# trunk's edge; knees caught below the trunk; legs folded under it, which lift it until it rolls.
@pytest.mark.parametrize(
    ("name", "seed"),
    [
        *(("a1", 16), ("a1", 20), ("a1", 64), ("b1", 7), ("b1", 16)),
        *(("b1", 201), ("go2", 123), ("go2", 215)),
    ],
)
def test_robot_gets_up_from_difficult_leg_poses(name: str, seed: int) -> None:
    robot = MonitoredRobot(name, seed)
    robot.arm()
    robot.request(Mode.RISE)
    assert robot.reaches(Mode.STAND, 25.0), (robot.supervisor.mode, robot.supervisor.damping_fault)
    robot.run(1.5)
    assert not robot.plant.truth.fell
    assert robot.protection_trips == 0
    assert robot.power < 100.0 * power_level(name)
    assert robot.torque_step_at_mode_change < 0.05


@pytest.mark.parametrize(
    ("name", "height"), [*((name, h) for name in ROBOTS for h in (0.3, 1.0)), ("go1", 0.6)]
)
def test_crouching_or_standing_robot_rises_without_folding(name: str, height: float) -> None:
    robot = standing_robot(name, 1)
    robot.run(0.5)
    if height < 1.0:
        robot.request(Mode.SIT)
        assert robot.run(4.0, lambda: robot.supervisor.rise_progress < height)
    robot.hold_by_position_control(3.0)
    assert robot.supervisor.arming.ready, robot.failures
    before = robot.plant.truth.q[2]
    robot.arm()
    robot.request(Mode.RISE)
    assert abs(robot.supervisor.rise_progress - height) < 0.05
    lowest = [before]
    assert robot.run(2.0, lambda: sinks(robot, lowest)), robot.supervisor.mode
    robot.run(1.5)
    assert lowest[0] > 0.75 * before
    assert robot.supervisor.mode == Mode.STAND
    assert robot.supervisor.controller.status == surefoot.Status.OK
    assert np.abs(robot.plant.truth.v).max() < 0.05
    assert robot.protection_trips == 0
    assert robot.torque_step_at_mode_change < 0.05


def sinks(robot: MonitoredRobot, lowest: list[float]) -> bool:
    lowest[0] = min(lowest[0], float(robot.plant.truth.q[2]))
    return robot.supervisor.mode == Mode.STAND


@pytest.mark.parametrize("name", ["go1", "b1"])
@pytest.mark.parametrize("height", [0.0, 0.5])
def test_aborted_rise_ends_lying_and_can_be_requested_again(name: str, height: float) -> None:
    robot = MonitoredRobot(name, 5)
    robot.arm()
    robot.request(Mode.RISE)
    assert robot.run(12.0, lambda: robot.supervisor.rise_progress > height or height == 0.0)
    robot.run(0.4)
    assert robot.supervisor.mode == Mode.RISE
    robot.request(Mode.SIT)
    assert robot.reaches(Mode.PASSIVE, 8.0)
    robot.run(2.0)
    assert is_damping(robot.command)
    assert robot.supervisor.armed
    assert robot.run(3.0, lambda: robot.supervisor.arming.ready), robot.failures
    robot.request(Mode.RISE)
    assert robot.reaches(Mode.STAND, 12.0)
    assert robot.protection_trips == 0
    assert robot.torque_step_at_mode_change < 0.05


def test_rise_can_be_aborted_while_torques_fade_in() -> None:
    robot = MonitoredRobot("go1", 5)
    robot.arm()
    robot.request(Mode.RISE)
    robot.run(0.1)
    robot.request(Mode.SIT)
    assert robot.supervisor.mode == Mode.PASSIVE
    robot.run(0.5)
    assert is_damping(robot.command)
    assert robot.torque_step_at_mode_change < 0.05


def test_stand_can_be_requested_while_sitting_down() -> None:
    robot = standing_robot("go1", 1)
    robot.run(0.5)
    robot.request(Mode.SIT)
    assert robot.run(4.0, lambda: robot.supervisor.rise_progress < 0.5)
    robot.request(Mode.STAND)
    assert robot.supervisor.mode == Mode.RISE
    assert robot.reaches(Mode.STAND, 4.0)
    robot.run(1.0)
    assert not robot.plant.truth.fell
    assert robot.protection_trips == 0


def test_out_of_order_requests_are_refused_without_motion() -> None:
    robot = MonitoredRobot("go1", 2)
    supervisor = robot.supervisor
    assert supervisor.request(Mode.RISE) == RequestStatus.NO_STATE
    assert supervisor.arm() == RequestStatus.NO_STATE
    robot.tick()
    assert supervisor.arm() == RequestStatus.NOT_READY
    for mode in (Mode.RISE, Mode.STAND, Mode.SIT):
        assert supervisor.request(mode) == RequestStatus.NOT_ARMED
    robot.arm()
    for mode in (Mode.STAND, Mode.SIT, Mode.PASSIVE, Mode.DAMPING):
        assert supervisor.request(mode) == RequestStatus.OUT_OF_ORDER
    robot.run(0.2)
    assert supervisor.mode == Mode.PASSIVE
    assert is_damping(robot.command)
    robot.request(Mode.RISE)
    assert supervisor.request(Mode.RISE) == RequestStatus.OUT_OF_ORDER
    assert supervisor.arm() == RequestStatus.OUT_OF_ORDER
    assert robot.reaches(Mode.STAND, 12.0)
    robot.run(0.5)
    assert supervisor.request(Mode.RISE) == RequestStatus.OUT_OF_ORDER


def test_one_of_eight_concurrent_requests_is_accepted() -> None:
    robot = MonitoredRobot("go1", 2)
    robot.arm()
    answers: list[RequestStatus] = []
    start_barrier = threading.Barrier(8)

    def ask() -> None:
        start_barrier.wait()
        answers.append(robot.supervisor.request(Mode.RISE))

    threads = [threading.Thread(target=ask) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert answers.count(RequestStatus.ACCEPTED) == 1
    assert answers.count(RequestStatus.BUSY) == 7


@pytest.mark.parametrize("how", ["stop", "button"])
@pytest.mark.parametrize("mode", [Mode.PASSIVE, Mode.RISE, Mode.STAND, Mode.SIT])
def test_stop_damps_at_once_until_armed_again(mode: Mode, how: str) -> None:
    robot = MonitoredRobot("go1", 1)
    robot.arm()
    if mode != Mode.PASSIVE:
        robot.request(Mode.RISE)
        robot.run(0.5)
    if mode in (Mode.STAND, Mode.SIT):
        assert robot.reaches(Mode.STAND, 12.0)
        robot.run(0.5)
    if mode == Mode.SIT:
        robot.request(Mode.SIT)
        robot.run(0.5)
    assert robot.supervisor.mode == mode
    if how == "stop":
        thread = threading.Thread(target=robot.supervisor.stop)
        thread.start()
        thread.join()
    else:
        robot.state.wirelessRemote[3] = 2  # B is bit 9 of the buttons, which begin at byte 2
    robot.tick()
    assert is_damping(robot.command)
    assert robot.supervisor.mode == Mode.DAMPING
    expected = FaultId.STOP if how == "stop" else FaultId.BUTTON
    assert robot.supervisor.damping_fault == expected
    assert robot.supervisor.request(Mode.RISE) == RequestStatus.LATCHED
    robot.run(4.0)
    assert robot.supervisor.mode == Mode.DAMPING
    robot.arm()
    assert robot.supervisor.mode == Mode.PASSIVE


class FailingTask(surefoot.Task):
    """A task with desired value 0, or NaN if it fails."""

    fails = False

    def rows(self) -> int:
        return 1

    def write(self, state: surefoot.RobotState, rows: surefoot.TaskRows) -> bool:
        rows.A_a[:] = 0.0
        rows.A_f[:] = 0.0
        rows.weight[:] = 1.0
        rows.b[:] = np.nan if self.fails else 0.0
        return True


def test_failed_controller_restarts_after_arming() -> None:
    robot, failing_task = MonitoredRobot("go1", 1), FailingTask()
    robot.supervisor.controller.add_task(failing_task)
    robot.arm()
    robot.request(Mode.RISE)
    assert robot.reaches(Mode.STAND, 12.0)
    robot.run(0.5)
    failing_task.fails = True
    assert robot.run(0.02, lambda: robot.supervisor.mode == Mode.DAMPING)
    assert robot.supervisor.damping_fault == FaultId.CONTROLLER
    assert is_damping(robot.command)
    failing_task.fails = False
    robot.run(2.0)
    robot.arm()
    robot.request(Mode.RISE)
    assert robot.reaches(Mode.STAND, 15.0), robot.supervisor.damping_fault
