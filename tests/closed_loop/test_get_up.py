# SPDX-License-Identifier: BSD-3-Clause
"""From lying to standing and back, under the power level in force."""

from __future__ import annotations

import threading

import numpy as np
import pytest
import surefoot
from get_up_helpers import Watched, damped
from plant_helpers import ROBOTS
from surefoot import FaultId, Mode, RequestStatus
from surefoot.faults.joint_faults import power_level


def risen(name: str, seed: int) -> Watched:
    robot = Watched(name, seed)
    robot.arm()
    robot.ask(Mode.RISE)
    assert robot.reaches(Mode.STAND, 12.0), (robot.supervisor.mode, robot.supervisor.reason)
    return robot


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("name", ROBOTS)
def test_a_lying_robot_gets_up_stands_and_lies_down_within_its_power(name: str, seed: int) -> None:
    robot = risen(name, seed)
    robot.run(1.5)
    truth = robot.plant.truth
    assert not truth.fell
    assert robot.supervisor.stand.status == surefoot.Status.OK
    assert np.abs(truth.v).max() < 0.05
    assert np.abs(robot.plant.data.qpos[7:] - robot.plant.robot.q_standing()[7:]).max() < 0.2
    robot.ask(Mode.SIT)
    assert robot.reaches(Mode.PASSIVE, 8.0)
    robot.run(1.0)
    assert damped(robot.command)
    assert np.abs(robot.plant.truth.v[:6]).max() < 0.05  # knees still sink, braked
    assert robot.refused == 0
    assert robot.power < 2.0 * 100.0 * power_level(name)  # for less than six reports
    assert robot.mode_step < 0.05
    assert robot.step_share < 0.3


# A foot on the back; hips turned in, thighs across the body's edge; knees pinned below it; legs
# drawn in under the body, which lift it until it rolls or falls back.
@pytest.mark.parametrize(
    ("name", "seed"),
    [
        *(("a1", 16), ("a1", 20), ("a1", 64), ("b1", 7), ("b1", 16)),
        *(("b1", 201), ("go2", 123), ("go2", 215)),
    ],
)
def test_legs_that_lie_badly_fold_all_the_same(name: str, seed: int) -> None:
    robot = Watched(name, seed)
    robot.arm()
    robot.ask(Mode.RISE)
    assert robot.reaches(Mode.STAND, 25.0), (robot.supervisor.mode, robot.supervisor.reason)
    robot.run(1.5)
    assert not robot.plant.truth.fell
    assert robot.refused == 0
    assert robot.power < 100.0 * power_level(name)
    assert robot.mode_step < 0.05


@pytest.mark.parametrize(
    ("name", "height"), [*((name, h) for name in ROBOTS for h in (0.3, 1.0)), ("go1", 0.6)]
)
def test_who_crouches_or_stands_does_not_fold_but_goes_on_up(name: str, height: float) -> None:
    robot = risen(name, 1)
    robot.run(0.5)
    if height < 1.0:
        robot.ask(Mode.SIT)
        assert robot.run(4.0, lambda: robot.supervisor.height < height)
    robot.hand_over(3.0)
    assert robot.supervisor.arming.ready, robot.failures
    before = robot.plant.truth.q[2]
    robot.arm()
    robot.ask(Mode.RISE)
    assert abs(robot.supervisor.height - height) < 0.05
    lowest = [before]
    assert robot.run(2.0, lambda: sinks(robot, lowest)), robot.supervisor.mode
    robot.run(1.5)
    assert lowest[0] > 0.75 * before
    assert robot.supervisor.mode == Mode.STAND
    assert robot.supervisor.stand.status == surefoot.Status.OK
    assert np.abs(robot.plant.truth.v).max() < 0.05
    assert robot.refused == 0
    assert robot.mode_step < 0.05


def sinks(robot: Watched, lowest: list[float]) -> bool:
    lowest[0] = min(lowest[0], float(robot.plant.truth.q[2]))
    return robot.supervisor.mode == Mode.STAND


@pytest.mark.parametrize("name", ["go1", "b1"])
@pytest.mark.parametrize("height", [0.0, 0.5])
def test_a_rise_is_aborted_to_lying_and_may_be_asked_for_again(name: str, height: float) -> None:
    robot = Watched(name, 5)
    robot.arm()
    robot.ask(Mode.RISE)
    assert robot.run(12.0, lambda: robot.supervisor.height > height or height == 0.0)
    robot.run(0.4)
    assert robot.supervisor.mode == Mode.RISE
    robot.ask(Mode.SIT)
    assert robot.reaches(Mode.PASSIVE, 8.0)
    robot.run(2.0)
    assert damped(robot.command)
    assert robot.supervisor.armed
    assert robot.run(3.0, lambda: robot.supervisor.arming.ready), robot.failures
    robot.ask(Mode.RISE)
    assert robot.reaches(Mode.STAND, 12.0)
    assert robot.refused == 0
    assert robot.mode_step < 0.05


def test_a_rise_may_be_aborted_while_its_torques_fade_in() -> None:
    robot = Watched("go1", 5)
    robot.arm()
    robot.ask(Mode.RISE)
    robot.run(0.1)
    robot.ask(Mode.SIT)
    assert robot.supervisor.mode == Mode.PASSIVE
    robot.run(0.5)
    assert damped(robot.command)
    assert robot.mode_step < 0.05


def test_on_the_way_down_it_may_be_asked_to_stand_again() -> None:
    robot = risen("go1", 1)
    robot.run(0.5)
    robot.ask(Mode.SIT)
    assert robot.run(4.0, lambda: robot.supervisor.height < 0.5)
    robot.ask(Mode.STAND)
    assert robot.supervisor.mode == Mode.RISE
    assert robot.reaches(Mode.STAND, 4.0)
    robot.run(1.0)
    assert not robot.plant.truth.fell
    assert robot.refused == 0


def test_what_is_out_of_order_is_refused_and_moves_nothing() -> None:
    robot = Watched("go1", 2)
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
    assert damped(robot.command)
    robot.ask(Mode.RISE)
    assert supervisor.request(Mode.RISE) == RequestStatus.OUT_OF_ORDER
    assert supervisor.arm() == RequestStatus.OUT_OF_ORDER
    assert robot.reaches(Mode.STAND, 12.0)
    robot.run(0.5)
    assert supervisor.request(Mode.RISE) == RequestStatus.OUT_OF_ORDER


def test_of_requests_from_many_threads_one_is_taken() -> None:
    robot = Watched("go1", 2)
    robot.arm()
    answers: list[RequestStatus] = []
    together = threading.Barrier(8)

    def ask() -> None:
        together.wait()
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
def test_a_stop_damps_at_once_and_until_it_is_armed_again(mode: Mode, how: str) -> None:
    robot = Watched("go1", 1)
    robot.arm()
    if mode != Mode.PASSIVE:
        robot.ask(Mode.RISE)
        robot.run(0.5)
    if mode in (Mode.STAND, Mode.SIT):
        assert robot.reaches(Mode.STAND, 12.0)
        robot.run(0.5)
    if mode == Mode.SIT:
        robot.ask(Mode.SIT)
        robot.run(0.5)
    assert robot.supervisor.mode == mode
    if how == "stop":
        thread = threading.Thread(target=robot.supervisor.stop)
        thread.start()
        thread.join()
    else:
        robot.state.wirelessRemote[3] = 2  # B is bit 9 of the buttons, which begin at byte 2
    robot.tick()
    assert damped(robot.command)
    assert robot.supervisor.mode == Mode.DAMPING
    expected = FaultId.STOP if how == "stop" else FaultId.BUTTON
    assert robot.supervisor.reason == expected
    assert robot.supervisor.request(Mode.RISE) == RequestStatus.LATCHED
    robot.run(4.0)
    assert robot.supervisor.mode == Mode.DAMPING
    robot.arm()
    assert robot.supervisor.mode == Mode.PASSIVE


class Spoiler(surefoot.Task):
    """A task that asks for nothing, or for what is no number."""

    spoils = False

    def rows(self) -> int:
        return 1

    def write(self, state: surefoot.RobotState, rows: surefoot.TaskRows) -> bool:
        rows.A_a[:] = 0.0
        rows.A_f[:] = 0.0
        rows.weight[:] = 1.0
        rows.b[:] = np.nan if self.spoils else 0.0
        return True


def test_a_controller_that_gave_up_begins_anew_after_arming() -> None:
    robot, spoiler = Watched("go1", 1), Spoiler()
    robot.supervisor.stand.add_task(spoiler)
    robot.arm()
    robot.ask(Mode.RISE)
    assert robot.reaches(Mode.STAND, 12.0)
    robot.run(0.5)
    spoiler.spoils = True
    assert robot.run(0.02, lambda: robot.supervisor.mode == Mode.DAMPING)
    assert robot.supervisor.reason == FaultId.CONTROLLER
    assert damped(robot.command)
    spoiler.spoils = False
    robot.run(2.0)
    robot.arm()
    robot.ask(Mode.RISE)
    assert robot.reaches(Mode.STAND, 15.0), robot.supervisor.reason
