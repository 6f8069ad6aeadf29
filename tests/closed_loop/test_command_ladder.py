# SPDX-License-Identifier: BSD-3-Clause
"""A go1 whose solves fail while it stands and is pushed, and what its torques do meanwhile."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
import surefoot
from surefoot import FaultId, Mode, Rung, StandController, Status
from surefoot.sim import Plant, Push

PERIOD = 0.002  # [s]
RATE = 0.095  # of a motor's torque limit in a period: what a Supervisor lets through
# Of a push that begins as solves fail: the ladder answers it evenly among the feet, in one tick,
# the program softer, by STEP at most. (A Supervisor lets RATE through of either.)
ANSWER = {"lateral": 0.095, "forward": 0.195}
STEP = 0.15
PUSHES = ("lateral", "forward")


class Spoiler(surefoot.Task):
    """A task of one row without weight, until it asks for what is no number."""

    def __init__(self) -> None:
        super().__init__()
        self.spoils = False

    def rows(self) -> int:
        return 1

    def write(self, state: surefoot.RobotState, rows: surefoot.TaskRows) -> bool:
        rows.A_a[:] = 0.0
        rows.A_f[:] = 0.0
        rows.weight[:] = 0.0
        rows.b[:] = math.nan if self.spoils else 0.0
        return True


class Run:
    """A pushed go1, its commands and the rungs they came from.

    Args:
        fails: Whether the solve of a tick fails.
        push: Direction, of half of what the pendulum survives, at 1 s.
    """

    def __init__(self, fails: Callable[[int], bool], push: str, seconds: float = 4.0) -> None:
        self.plant = Plant("go1")
        self.controller, task = StandController(self.plant.robot), Spoiler()
        self.controller.add_task(task)
        report = self.plant.reset()
        self.start = self.plant.truth
        impulse = 0.5 * self.plant.lip_limit(push)
        self.plant.add_push(Push(push, impulse, 0.1, 1.0))
        self.tau, self.rungs, self.statuses, self.damps = [], [], [], []
        for k in range(round(seconds / PERIOD)):
            task.spoils = fails(k)
            command = self.controller.update(report)
            self.tau.append([command.motorCmd[i].tau for i in range(12)])
            self.damps.append(command.motorCmd[0].Kd > 0.0)
            self.rungs.append(self.controller.rung)
            self.statuses.append(self.controller.status)
            report = self.plant.step(command)

    def jump(self) -> float:
        """Greatest change of a torque, of its limit, to, from or between ticks of the ladder.

        Going over to the motors' own damping is at once by design and is not counted.
        """
        steps = np.abs(np.diff(self.tau, axis=0)) / self.plant.robot.config.tau_max
        bridged = np.array([rung == Rung.FORCES for rung in self.rungs])
        counted = (bridged[1:] | bridged[:-1]) & ~np.array(self.damps[1:])
        return float(steps[counted].max())

    def settled(self) -> bool:
        now, then = (t.q[:3] - t.p_world_feet.mean(axis=1) for t in (self.plant.truth, self.start))
        return not self.plant.truth.fell and np.linalg.norm(now - then) < 0.010


@pytest.mark.parametrize("push", PUSHES)
@pytest.mark.parametrize("burst", [1, 3, 5])
def test_a_pushed_robot_stands_whose_solves_fail_in_every_tenth_of_a_second(
    push: str, burst: int
) -> None:
    run = Run(lambda k: k >= 50 and k % 50 < burst, push)
    assert run.settled()
    failed = [k for k, rung in enumerate(run.rungs) if rung != Rung.SOLVED]
    assert failed == [k for k in range(50, len(run.rungs)) if k % 50 < burst]
    assert {run.rungs[k] for k in failed} == {Rung.FORCES}
    assert {run.statuses[k] for k in failed} == {Status.BAD_TASK}
    assert run.controller.rung_count(Rung.FORCES) == len(failed)
    assert not any(run.damps)
    assert run.jump() <= ANSWER[push]


@pytest.mark.parametrize("push", PUSHES)
def test_torques_step_little_as_a_push_begins(push: str) -> None:
    run = Run(lambda k: False, push)
    step = np.abs(np.diff(run.tau, axis=0)) / run.plant.robot.config.tau_max
    assert 0.03 < step.max() < STEP


@pytest.mark.parametrize("push", PUSHES)
def test_a_failure_that_lasts_ends_in_damping_within_twenty_milliseconds(push: str) -> None:
    begin = 540  # in the middle of the push
    run = Run(lambda k: k >= begin, push, 2.0)
    damped = run.damps.index(True)
    assert 0.010 <= (damped - begin) * PERIOD <= 0.020
    assert all(run.damps[damped:])
    assert set(run.rungs[begin:damped]) == {Rung.FORCES}
    assert set(run.rungs[damped:]) == {Rung.DAMPING}
    assert set(run.statuses[damped:]) == {Status.DAMPING}
    assert run.controller.fault == Status.BAD_TASK
    assert run.jump() <= RATE


def test_a_supervisor_tells_of_it_and_goes_on_until_it_lasts() -> None:
    plant, task = Plant("go1"), Spoiler()
    options = surefoot.SupervisorOptions(start=surefoot.Start.STANDING)
    supervisor = surefoot.Supervisor(plant.robot, options=options)
    supervisor.stand.add_task(task)
    report = plant.reset()
    for k in range(600):
        task.spoils = k >= 100 and k % 100 < 3
        report = plant.step(supervisor.update(report))
        told = FaultId.PROGRAM in supervisor.faults.active
        assert told == task.spoils
        assert supervisor.fresh
        assert supervisor.mode == Mode.STAND
    assert supervisor.faults.count(FaultId.PROGRAM) == 5
    task.spoils = True
    for _ in range(5):
        report = plant.step(supervisor.update(report))
        assert supervisor.mode == Mode.STAND
    plant.step(supervisor.update(report))
    assert (supervisor.mode, supervisor.reason) == (Mode.DAMPING, FaultId.CONTROLLER)
    assert FaultId.PROGRAM not in supervisor.faults.active


@pytest.mark.parametrize("start", [surefoot.Start.STANDING, surefoot.Start.LYING])
def test_a_program_that_never_solves_is_given_up_within_twenty_milliseconds(
    start: surefoot.Start,
) -> None:
    plant, task = Plant("go1"), Spoiler()
    supervisor = surefoot.Supervisor(
        plant.robot, options=surefoot.SupervisorOptions(start=start, power_level=1)
    )
    supervisor.stand.add_task(task)
    task.spoils = True
    standing = start == surefoot.Start.STANDING
    report = plant.reset() if standing else plant.reset_lying(np.random.default_rng(3))
    ticks = 0
    for _ in range(10_000):
        if supervisor.mode == Mode.PASSIVE and not standing:
            if supervisor.armed:
                supervisor.request(Mode.RISE)
            else:
                supervisor.arm()
        report = plant.step(supervisor.update(report))
        ticks += supervisor.mode == Mode.STAND
        if supervisor.mode == Mode.DAMPING:
            break
    assert (supervisor.mode, supervisor.reason) == (Mode.DAMPING, FaultId.CONTROLLER)
    assert 0 < ticks <= 10
