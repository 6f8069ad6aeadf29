"""Recorded reports through a fresh controller and through its parts, every call timed."""

from __future__ import annotations

from dataclasses import dataclass, field
from time import perf_counter_ns
from typing import Any

from surefoot._core import (
    RobotState,
    Solution,
    StandController,
    StandOptions,
    StateEstimator,
    Status,
    WholeBodyController,
    WholeBodyOptions,
    is_usable,
)
from surefoot.bench.machine import describe_machine
from surefoot.bench.recording import Recording, record
from surefoot.bench.settings import BenchSettings
from surefoot.bench.timing import distribution, without_garbage_collection


@dataclass
class Stage:
    """One stage's calls.

    Attributes:
        durations: Of every call [ns].
        iterations: Of the solver in every call; empty where nothing is solved.
        failures: Calls whose status was not usable.
    """

    durations: list[int] = field(default_factory=list)
    iterations: list[int] = field(default_factory=list)
    failures: int = 0

    def add(self, duration: int, status: Status, solution: Solution | None = None) -> None:
        """Add a call."""
        self.durations.append(duration)
        self.failures += not is_usable(status)
        if solution is not None:
            self.iterations.append(solution.iterations)


def run_bench(settings: BenchSettings) -> dict[str, Any]:
    """Record a run, replay it and return every figure as plain JSON types; raises Error."""
    recording = record(settings)
    with without_garbage_collection():
        null = time_null(len(recording.reports))
        tick = time_ticks(recording, settings)
        estimate, states = time_estimates(recording)
        whole_body = time_whole_body(recording, settings, states)
    stages = {"tick": tick, "estimate": estimate, "whole_body": whole_body, "null": null}
    return {
        "robot": recording.robot.name,
        "form": settings.form.name.lower(),
        "ticks": len(recording.reports),
        "rate": settings.rate,
        "seed": settings.seed,
        "push_ns": round(recording.push.impulse, 3),
        **{f"{name}_us": distribution(stage.durations) for name, stage in stages.items()},
        "iterations": {name: _spread(stage) for name, stage in stages.items() if stage.iterations},
        "failures": {name: stage.failures for name, stage in stages.items() if name != "null"},
        "machine": describe_machine(),
    }


def time_ticks(recording: Recording, settings: BenchSettings) -> Stage:
    """Time StandController.update(): all that a control period asks for."""
    robot = recording.robot
    controller = StandController(robot, robot.config.gains, StandOptions(form=settings.form))
    stage, update = Stage(), controller.update
    for report in recording.reports:
        start = perf_counter_ns()
        update(report)
        duration = perf_counter_ns() - start
        stage.add(duration, controller.status, controller.solution)
    return stage


def time_estimates(recording: Recording) -> tuple[Stage, list[RobotState]]:
    """Time StateEstimator.update(), and return the states that it made."""
    estimator = StateEstimator(recording.robot)
    estimator.set_gains(recording.robot.config.gains)
    stage, states, update = Stage(), [], estimator.update
    for report in recording.reports:
        start = perf_counter_ns()
        status = update(report, recording.period)
        duration = perf_counter_ns() - start
        stage.add(duration, status)
        states.append(estimator.state)
    return stage, states


def time_whole_body(
    recording: Recording, settings: BenchSettings, states: list[RobotState]
) -> Stage:
    """Time WholeBodyController.update(): hold the first of the states throughout."""
    robot, options = recording.robot, WholeBodyOptions(form=settings.form)
    controller = WholeBodyController(robot, robot.config.gains, options)
    reference = controller.hold(states[0])
    stage, update = Stage(), controller.update
    for state in states:
        start = perf_counter_ns()
        solution = update(state, reference)
        duration = perf_counter_ns() - start
        stage.add(duration, solution.status, solution)
    return stage


def time_null(calls: int) -> Stage:
    """Time a call that does nothing: what clock and call add to every other figure."""
    stage, update = Stage(), _nothing
    for _ in range(calls):
        start = perf_counter_ns()
        update(None)
        duration = perf_counter_ns() - start
        stage.add(duration, Status.OK)
    return stage


def _nothing(_: Any) -> None:
    pass


def _spread(stage: Stage) -> dict[str, float]:
    mean = sum(stage.iterations) / len(stage.iterations)
    return {"mean": round(mean, 3), "max": max(stage.iterations)}
