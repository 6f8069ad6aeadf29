"""One cell of the matrix, run and judged."""

from __future__ import annotations

from typing import Any

from surefoot._core import Error
from surefoot.faults.approach import ASKED_TO_RISE, approach
from surefoot.faults.catalogue import Cell, find_cell
from surefoot.faults.observe import Observed, observe
from surefoot.faults.reaction import Reaction
from surefoot.faults.scene import Scene
from surefoot.faults.setting import Setup
from surefoot.faults.verdict import falls_fast, reaction_time, shortcomings, untold
from surefoot.plain import plain


def run_cell(setup: Setup, name: str) -> dict[str, Any]:
    """Run a cell and return what came of it as plain JSON types.

    Args:
        setup: The robot, and where it lies.
        name: The cell's id.
    """
    cell = find_cell(name)
    fault = cell.case.make()
    tick0 = fault.tick0(0)
    if tick0 is not None:
        onset = _ticks_before(setup, cell)
        tick0 = fault.tick0(onset)
    scene = Scene(setup, fault, cell.case.level, tick0 or 0)
    try:
        record: dict[str, Any] = plain(_run(scene, cell, setup.height))
        return record
    finally:
        scene.close()


def _run(scene: Scene, cell: Cell, height: float) -> dict[str, Any]:
    problem = ""
    if not (cell.expect.reaction == Reaction.REFUSE and scene.fault.from_start):
        problem = approach(scene, ASKED_TO_RISE if _shows_early(scene, cell) else cell.mode)
    if _shows_early(scene, cell) and not scene.armed and scene.failures:
        # Arming refuses by name: as good, and sooner.
        return _record(scene, cell, Observed(), scene.judge.violations())
    seen = Observed() if problem else observe(scene, cell.expect, cell.mode)
    found = [problem] if problem else shortcomings(seen, cell.expect, cell.mode, height)
    if not problem and cell.case.says and cell.case.says not in scene.failures:
        found.append(f"the refusal does not name {cell.case.says}: {scene.failures or 'nothing'}")
    if not problem:
        found += untold(seen, cell.expect)
        found += falls_fast(seen, height) if cell.case.gentle else []
    if cell.row.id == "healthy":
        found += [f"a false {fault}" for fault in scene.told]
    found += scene.fault.complaints() + scene.judge.violations()
    return _record(scene, cell, seen, found)


def _shows_early(scene: Scene, cell: Cell) -> bool:
    """Return whether a fault from the start may show as soon as the robot is asked to rise."""
    expect = cell.expect
    return scene.fault.from_start and (expect.reaction == Reaction.STAY or expect.unless != "")


def _record(scene: Scene, cell: Cell, seen: Observed, found: list[str]) -> dict[str, Any]:
    judge, expect = scene.judge, cell.expect
    return {
        "id": cell.id,
        "row": cell.row.id,
        "injection": cell.case.injection,
        "what": cell.case.what,
        "mode": cell.mode,
        "expected": expect.reaction.name.lower(),
        "within_s": expect.within,
        "reaction_s": reaction_time(seen, expect),
        "damped_s": seen.damped,
        "told_s": seen.told,
        "fault": expect.fault,
        "faults_told": scene.told,
        "ended": seen.mode.name.lower(),
        "damping_reason": scene.supervisor.reason.name.lower(),
        "not_finite": judge.not_finite,
        "torque_share": judge.torque_share,
        "torque_step_share": judge.rate_share,
        "power_trips": judge.power_trips,
        "greatest_power_W": judge.power,
        "held_s": judge.held,
        "speed_down": seen.speed,
        "simulated_s": scene.plant.time,
        "verdict": "fail" if found else "pass",
        "reason": "; ".join(found),
    }


def _ticks_before(setup: Setup, cell: Cell) -> int:
    """Return how far the robot's clock goes until the fault begins [ms]."""
    rehearsal = Scene(setup, cell.case.make(), cell.case.level)
    first = rehearsal.tick
    try:
        approach(rehearsal, cell.mode)
        return rehearsal.tick - first
    finally:
        rehearsal.close()


def broken(name: str, problem: BaseException) -> dict[str, Any]:
    """Return what stands for a cell that could not be run."""
    cell = find_cell(name)
    if isinstance(problem, Error):
        text = str(problem)
    else:
        text = f"{type(problem).__name__}: {problem}"
    return {
        "id": cell.id,
        "row": cell.row.id,
        "injection": cell.case.injection,
        "what": cell.case.what,
        "mode": cell.mode,
        "expected": cell.expect.reaction.name.lower(),
        "broken": True,
        "verdict": "fail",
        "reason": f"could not be run: {text}",
    }
