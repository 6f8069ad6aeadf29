"""Run of one cell of the matrix, and its result."""

from __future__ import annotations

from typing import Any

from surefoot._core import Error
from surefoot.faults.catalogue import Cell, find_cell
from surefoot.faults.expectation import Reaction
from surefoot.faults.matrix.matrix_setup import MatrixSetup
from surefoot.faults.matrix.observation import Observation, observe
from surefoot.faults.matrix.reach_mode import RISE_REQUESTED, reach_mode
from surefoot.faults.matrix.scenario import Scenario
from surefoot.faults.matrix.verdict import (
    descends_too_fast,
    deviations,
    reaction_time,
    unreported_fault,
)
from surefoot.files.json_values import json_value


def run_cell(setup: MatrixSetup, name: str) -> dict[str, Any]:
    """Run a cell and return its result as JSON values.

    Args:
        setup: Setup of the matrix.
        name: Id of the cell.
    """
    cell = find_cell(name)
    fault = cell.case.make_fault()
    # A fault that sets the first tick needs the time of its onset. A trial run measures this time.
    tick0 = fault.tick0(0)
    if tick0 is not None:
        onset = _ticks_before(setup, cell)
        tick0 = fault.tick0(onset)
    scenario = Scenario(setup, fault, cell.case.level, tick0 or 0, cell.mode == "walking")
    try:
        record: dict[str, Any] = json_value(_run(scenario, cell, setup.standing_height))
        return record
    finally:
        scenario.close()


def _run(scenario: Scenario, cell: Cell, height: float) -> dict[str, Any]:
    """Run the scenario of a cell and return its result; height: standing height of the base [m]."""
    problem = ""
    if not (cell.expectation.reaction == Reaction.REFUSE and scenario.fault.from_start):
        problem = reach_mode(
            scenario, RISE_REQUESTED if _may_be_detected_on_rise(scenario, cell) else cell.mode
        )
    if _may_be_detected_on_rise(scenario, cell) and not scenario.armed and scenario.arming_failures:
        # The failed arming checks name the fault, which counts as a detection during the rise.
        return _record(scenario, cell, Observation(), scenario.monitor.violations())
    observed = Observation() if problem else observe(scenario, cell.expectation, cell.mode)
    problems = [problem] if problem else deviations(observed, cell.expectation, cell.mode, height)
    if (
        not problem
        and cell.case.refusal_text
        and cell.case.refusal_text not in scenario.arming_failures
    ):
        problems.append(
            f"the refusal does not name {cell.case.refusal_text}: "
            f"{scenario.arming_failures or 'nothing'}"
        )
    if not problem:
        problems += unreported_fault(observed, cell.expectation)
        problems += descends_too_fast(observed, height) if cell.case.slow_descent else []
    if cell.row.id == "healthy":
        problems += [f"false report of {fault}" for fault in scenario.reported_faults]
    problems += scenario.fault.problems() + scenario.monitor.violations()
    return _record(scenario, cell, observed, problems)


def _may_be_detected_on_rise(scenario: Scenario, cell: Cell) -> bool:
    """Return True for a fault from before arming that may be detected only when a rise begins."""
    expectation = cell.expectation
    return scenario.fault.from_start and (
        expectation.reaction == Reaction.STAY or expectation.alternative != ""
    )


def _record(
    scenario: Scenario, cell: Cell, observed: Observation, problems: list[str]
) -> dict[str, Any]:
    monitor, expectation = scenario.monitor, cell.expectation
    return {
        "id": cell.id,
        "row": cell.row.id,
        "injection": cell.case.injection,
        "what": cell.case.description,
        "mode": cell.mode,
        "expected": expectation.reaction.name.lower(),
        "within_s": expectation.within,
        "reaction_s": reaction_time(observed, expectation),
        "damped_s": observed.damped_at,
        "told_s": observed.reported_at,
        "fault": expectation.fault,
        "faults_told": scenario.reported_faults,
        "ended": observed.mode.name.lower(),
        "damping_reason": scenario.supervisor.damping_fault.name.lower(),
        "not_finite": monitor.not_finite,
        "torque_share": monitor.torque_share,
        "torque_step_share": monitor.torque_step_share,
        "power_trips": monitor.power_trips,
        "greatest_power_W": monitor.power,
        "held_s": monitor.hold_time,
        "speed_down": observed.max_descent_speed,
        "simulated_s": scenario.plant.time,
        "verdict": "fail" if problems else "pass",
        "reason": "; ".join(problems),
    }


def _ticks_before(setup: MatrixSetup, cell: Cell) -> int:
    """Run a trial up to the onset of the fault and return the onset [ms].

    The onset is the time on the robot's clock since the first sample.
    """
    trial = Scenario(setup, cell.case.make_fault(), cell.case.level, walking=cell.mode == "walking")
    first = trial.tick
    try:
        reach_mode(trial, cell.mode)
        return trial.tick - first
    finally:
        trial.close()


def error_result(name: str, problem: BaseException) -> dict[str, Any]:
    """Return the failed result of a cell whose run raised an exception."""
    cell = find_cell(name)
    if isinstance(problem, Error):
        text = str(problem)
    else:
        text = f"{type(problem).__name__}: {problem}"
    return {
        "id": cell.id,
        "row": cell.row.id,
        "injection": cell.case.injection,
        "what": cell.case.description,
        "mode": cell.mode,
        "expected": cell.expectation.reaction.name.lower(),
        "broken": True,
        "verdict": "fail",
        "reason": f"could not be run: {text}",
    }
