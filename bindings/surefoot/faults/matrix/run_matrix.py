"""Run of a fault matrix: runs all cells in this process or in several, and collects the results."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from concurrent.futures import as_completed
from concurrent.futures.process import BrokenProcessPool
from typing import Any

from surefoot._core import Error
from surefoot.faults.catalogue import choose_cells
from surefoot.faults.matrix.matrix_settings import FaultSettings
from surefoot.faults.matrix.matrix_setup import MatrixSetup, make_setup
from surefoot.faults.matrix.run_cell import error_result, run_cell
from surefoot.files.result_store import open_result_store
from surefoot.robot.power_level import power_level
from surefoot.system.machine import describe_machine
from surefoot.system.worker_processes import killable_pool

Progress = Callable[[int, int], None]
"""Function that receives the number of cells done and the total number of cells."""


def run_faults(settings: FaultSettings, progress: Progress | None = None) -> dict[str, Any]:
    """Run a fault matrix and return the results as JSON values.

    Args:
        settings: Settings of the matrix.
        progress: Function that is called after every cell.

    Raises:
        Error: The robot or a pattern is unknown, a process died, or the store belongs to a run
            with other settings.
        OSError: The store cannot be written; it keeps the results written before.
    """
    names = [cell.id for cell in choose_cells(settings.only, settings.taken_over)]
    setup = make_setup(settings.description, settings.seed, taken_over=settings.taken_over)
    robot = setup.description.name
    with open_result_store(settings.store, "surefoot faults", settings.identity_values()) as store:
        pending = [name for name in names if (robot, name) not in store.results]
        cells = {name: store.results.get((robot, name), {}) for name in names}
        for k, result in enumerate(_results(setup, pending, settings.jobs), 1):
            cells[result["id"]] = result
            if not result.get("broken"):
                store.add(robot, result["id"], result)
            if progress is not None:
                progress(len(names) - len(pending) + k, len(names))
    return summarise(settings, setup, list(cells.values()))


def summarise(
    settings: FaultSettings, setup: MatrixSetup, cells: list[dict[str, Any]]
) -> dict[str, Any]:
    """Return the results of all cells and their summary as JSON values."""
    failures = [cell for cell in cells if cell["verdict"] != "pass"]
    robot = setup.description.name
    return {
        "robot": robot,
        "seed": settings.seed,
        "only": list(settings.only),
        "taken_over": settings.taken_over,
        "power_level": power_level(robot),
        "passed": len(cells) - len(failures),
        "failed": len(failures),
        "failures": [{"id": cell["id"], "reason": cell["reason"]} for cell in failures],
        "versions": describe_machine()["versions"],
        "cells": cells,
    }


def _results(setup: MatrixSetup, names: list[str], jobs: int) -> Iterator[dict[str, Any]]:
    """Yield the results of cells; with more than one job, in the order in which they end."""
    if jobs == 1:
        for name in names:
            yield run_or_error_result(setup, name)
        return
    with killable_pool(max(1, min(jobs, len(names)))) as pool:
        futures = [pool.submit(run_or_error_result, setup, name) for name in names]
        try:
            for future in as_completed(futures):
                yield future.result()
        except BrokenProcessPool:
            raise Error(
                "faults: a worker process died; memory may be too small, try fewer --jobs"
            ) from None


def run_or_error_result(setup: MatrixSetup, name: str) -> dict[str, Any]:
    """Run a cell and return its result; return a failed result if the run raises an exception."""
    try:
        return run_cell(setup, name)
    except Exception as problem:
        return error_result(name, problem)
