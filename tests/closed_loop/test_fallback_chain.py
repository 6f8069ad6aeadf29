# SPDX-License-Identifier: BSD-3-Clause
"""A pushed go1 whose QP solves fail: its torques and fallback levels."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
import surefoot
from surefoot import FallbackLevel, FaultId, Mode, StandController, Status
from surefoot.sim import Plant, Push

PERIOD = 0.002  # [s]
MAX_SUPERVISED_STEP = 0.095  # share of the torque limit per 2 ms that a Supervisor allows
# Largest torque step when a push begins while solves fail: fallback level FORCES shares the load
# evenly among the feet within one tick. The QP steps less, MAX_SOLVED_STEP at most. A Supervisor
# limits both to MAX_SUPERVISED_STEP.
MAX_FALLBACK_STEP = {"lateral": 0.095, "forward": 0.195}
MAX_SOLVED_STEP = 0.15
PUSHES = ("lateral", "forward")


class FailingTask(surefoot.Task):
    """A task of one row with zero weight, which can output NaN."""

    def __init__(self) -> None:
        super().__init__()
        self.outputs_nan = False

    def rows(self) -> int:
        return 1

    def write(self, state: surefoot.RobotState, rows: surefoot.TaskRows) -> bool:
        rows.A_a[:] = 0.0
        rows.A_f[:] = 0.0
        rows.weight[:] = 0.0
        rows.b[:] = math.nan if self.outputs_nan else 0.0
        return True


class PushedRun:
    """A pushed go1, its commands and their fallback levels.

    Args:
        fails: Returns whether the solve of a tick fails.
        push: Direction of a push of half the LIP push limit, at 1 s.
        seconds: Duration of the run [s].
    """

    def __init__(self, fails: Callable[[int], bool], push: str, seconds: float = 4.0) -> None:
        self.plant = Plant("go1")
        self.controller, task = StandController(self.plant.robot), FailingTask()
        self.controller.add_task(task)
        report = self.plant.reset()
        self.start = self.plant.truth
        impulse = 0.5 * self.plant.lip_push_limit(push)
        self.plant.add_push(Push(push, impulse, 0.1, 1.0))
        self.tau, self.fallback_levels, self.statuses, self.damping_flags = [], [], [], []
        for k in range(round(seconds / PERIOD)):
            task.outputs_nan = fails(k)
            command = self.controller.update(report)
            self.tau.append([command.motorCmd[i].tau for i in range(12)])
            self.damping_flags.append(command.motorCmd[0].Kd > 0.0)
            self.fallback_levels.append(self.controller.fallback_level)
            self.statuses.append(self.controller.status)
            report = self.plant.step(command)

    def jump(self) -> float:
        """Return the largest torque step at ticks of level FORCES, as a share of the limit.

        The step to damping is immediate by design and does not count.
        """
        steps = np.abs(np.diff(self.tau, axis=0)) / self.plant.robot.config.tau_max
        bridged = np.array(
            [fallback_level == FallbackLevel.FORCES for fallback_level in self.fallback_levels]
        )
        counted = (bridged[1:] | bridged[:-1]) & ~np.array(self.damping_flags[1:])
        return float(steps[counted].max())

    def settled(self) -> bool:
        now, then = (t.q[:3] - t.p_world_feet.mean(axis=1) for t in (self.plant.truth, self.start))
        return not self.plant.truth.fell and np.linalg.norm(now - then) < 0.010


@pytest.mark.parametrize("push", PUSHES)
@pytest.mark.parametrize("burst", [1, 3, 5])
def test_pushed_robot_stands_with_solve_failures_every_100_ms(push: str, burst: int) -> None:
    run = PushedRun(lambda k: k >= 50 and k % 50 < burst, push)
    assert run.settled()
    failed = [
        k
        for k, fallback_level in enumerate(run.fallback_levels)
        if fallback_level != FallbackLevel.SOLVED
    ]
    assert failed == [k for k in range(50, len(run.fallback_levels)) if k % 50 < burst]
    assert {run.fallback_levels[k] for k in failed} == {FallbackLevel.FORCES}
    assert {run.statuses[k] for k in failed} == {Status.BAD_TASK}
    assert run.controller.fallback_count(FallbackLevel.FORCES) == len(failed)
    assert not any(run.damping_flags)
    assert run.jump() <= MAX_FALLBACK_STEP[push]


@pytest.mark.parametrize("push", PUSHES)
def test_torque_step_at_push_start_is_below_15_percent(push: str) -> None:
    run = PushedRun(lambda k: False, push)
    step = np.abs(np.diff(run.tau, axis=0)) / run.plant.robot.config.tau_max
    assert 0.03 < step.max() < MAX_SOLVED_STEP


@pytest.mark.parametrize("push", PUSHES)
def test_lasting_solve_failure_damps_within_20_ms(push: str) -> None:
    begin = 540  # in the middle of the push
    run = PushedRun(lambda k: k >= begin, push, 2.0)
    damped = run.damping_flags.index(True)
    assert 0.010 <= (damped - begin) * PERIOD <= 0.020
    assert all(run.damping_flags[damped:])
    assert set(run.fallback_levels[begin:damped]) == {FallbackLevel.FORCES}
    assert set(run.fallback_levels[damped:]) == {FallbackLevel.DAMPING}
    assert set(run.statuses[damped:]) == {Status.DAMPING}
    assert run.controller.fault == Status.BAD_TASK
    assert run.jump() <= MAX_SUPERVISED_STEP


def test_supervisor_reports_solve_failures_and_damps_when_they_last() -> None:
    plant, task = Plant("go1"), FailingTask()
    options = surefoot.SupervisorOptions(start=surefoot.Start.STANDING)
    supervisor = surefoot.Supervisor(plant.robot, options=options)
    supervisor.controller.add_task(task)
    report = plant.reset()
    for k in range(600):
        task.outputs_nan = k >= 100 and k % 100 < 3
        report = plant.step(supervisor.update(report))
        told = FaultId.PROGRAM in supervisor.faults.active
        assert told == task.outputs_nan
        assert supervisor.command_is_fresh
        assert supervisor.mode == Mode.STAND
    assert supervisor.faults.count(FaultId.PROGRAM) == 5
    task.outputs_nan = True
    for _ in range(5):
        report = plant.step(supervisor.update(report))
        assert supervisor.mode == Mode.STAND
    plant.step(supervisor.update(report))
    assert (supervisor.mode, supervisor.damping_fault) == (Mode.DAMPING, FaultId.CONTROLLER)
    assert FaultId.PROGRAM not in supervisor.faults.active


@pytest.mark.parametrize("start", [surefoot.Start.STANDING, surefoot.Start.LYING])
def test_qp_that_never_solves_damps_within_20_ms(
    start: surefoot.Start,
) -> None:
    plant, task = Plant("go1"), FailingTask()
    supervisor = surefoot.Supervisor(
        plant.robot, options=surefoot.SupervisorOptions(start=start, power_level=1)
    )
    supervisor.controller.add_task(task)
    task.outputs_nan = True
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
    assert (supervisor.mode, supervisor.damping_fault) == (Mode.DAMPING, FaultId.CONTROLLER)
    assert 0 < ticks <= 10
