"""Processes with a deadline: one that does not answer in time is killed, and replaced."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from contextlib import suppress
from multiprocessing.connection import wait
from typing import Any

from surefoot.assess.condition_plant import RobotSource
from surefoot.assess.worker import Worker, WorkItem


def run_work(
    work_items: Iterable[WorkItem], source: RobotSource, jobs: int, deadline: float
) -> Iterator[tuple[WorkItem, dict[str, Any]]]:
    """Run work on several processes; yield what came of each, in the order in which they end.

    A process that dies, or of which nothing is heard for `deadline`, takes the unit that it was at
    with it: {"broken": why, LOST_KEY: True}. Another takes its place. Of a contestant that has returned
    before, a unit that was late is tried once more, for machines stall as well.

    Args:
        work_items: In the order in which they are begun.
        source: The robot.
        jobs: Processes.
        deadline: For one run [s] of wall time.

    Raises:
        Error: Processes cannot be started.
    """
    queue, retries = iter(work_items), list[WorkItem]()
    returned_controllers, retried_units = set[str](), set[tuple[str, str]]()
    crew: list[Worker] = []
    try:
        for work in queue:
            crew.append(_start_worker(work, source, deadline))
            if len(crew) == jobs:
                break
        while crew:
            for worker, result in _collect_results(crew):
                assert worker.work is not None
                work_id = worker.work.controller_under_test.name, worker.work.unit.key
                if (
                    worker.timed_out
                    and work_id[0] in returned_controllers
                    and work_id not in retried_units
                ):
                    retried_units.add(work_id)
                    retries.append(worker.work)
                else:
                    yield worker.work, result
                if not worker.pipe.closed:
                    returned_controllers.add(work_id[0])
                next_work = retries.pop() if retries else next(queue, None)
                crew = _next_work_to(crew, worker, next_work, source, deadline)
    finally:
        for worker in crew:
            worker.kill()


def _collect_results(crew: list[Worker]) -> list[tuple[Worker, dict[str, Any]]]:
    """Wait for results, and for those that will never come."""
    timeout = min(worker.heartbeat_due for worker in crew) - time.monotonic()
    ready = wait([worker.pipe for worker in crew], max(0.0, timeout))
    results = []
    for worker in crew:
        if worker.pipe in ready:
            result = worker.receive()
            if result is not None:
                results.append((worker, result))
        elif time.monotonic() > worker.heartbeat_due:
            results.append((worker, worker.give_up_leg()))
    return results


def _start_worker(work: WorkItem, source: RobotSource, deadline: float) -> Worker:
    worker = Worker(source)
    with suppress(OSError):  # who has died by now tells so where it is heard
        worker.assign(work, deadline)
    return worker


def _next_work_to(
    crew: list[Worker], worker: Worker, work: WorkItem | None, source: RobotSource, deadline: float
) -> list[Worker]:
    """Give a worker more to do, or let it go; replace it if it is gone."""
    if not worker.pipe.closed and work is not None:
        try:
            worker.assign(work, deadline)
            return crew
        except OSError:
            pass  # it has died since its last result: this work is not what it died of
    if not worker.pipe.closed:
        worker.kill()
    other_workers = [other for other in crew if other is not worker]
    return (
        other_workers if work is None else [*other_workers, _start_worker(work, source, deadline)]
    )
