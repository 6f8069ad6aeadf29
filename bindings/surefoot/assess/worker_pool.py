"""Pool of worker processes: a process that misses its deadline is killed and replaced."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from contextlib import suppress
from multiprocessing.connection import wait
from typing import Any

from surefoot.assess.robot_source import RobotSource
from surefoot.assess.worker import Worker, WorkItem


def run_work(
    work_items: Iterable[WorkItem], source: RobotSource, jobs: int, deadline: float
) -> Iterator[tuple[WorkItem, dict[str, Any]]]:
    """Run work on several processes; yield each item with its result when the item ends.

    If a process dies, or sends no heartbeat within its deadline, its unit gets the result
    {"broken": reason, LOST_KEY: True}, and a new process replaces the old one. If the same
    controller has completed a unit before, a unit that missed its deadline runs a second time,
    because the machine may have stalled.

    Args:
        work_items: Work, in the order in which it starts.
        source: The robot.
        jobs: Number of processes.
        deadline: Longest wall time of one run [s]; multiplied by the unit's deadline_factor.

    Raises:
        Error: Processes cannot be started.
    """
    queue, retries = iter(work_items), list[WorkItem]()
    returned_controllers, retried_units = set[str](), set[tuple[str, str]]()
    workers: list[Worker] = []
    try:
        for work in queue:
            workers.append(_start_worker(work, source, deadline))
            if len(workers) == jobs:
                break
        while workers:
            for worker, result in _collect_results(workers):
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
                workers = _next_work_to(workers, worker, next_work, source, deadline)
    finally:
        for worker in workers:
            worker.kill()


def _collect_results(workers: list[Worker]) -> list[tuple[Worker, dict[str, Any]]]:
    """Wait for messages; return the results that arrived, and the results of late workers."""
    timeout = min(worker.heartbeat_due for worker in workers) - time.monotonic()
    ready = wait([worker.pipe for worker in workers], max(0.0, timeout))
    results = []
    for worker in workers:
        if worker.pipe in ready:
            result = worker.receive()
            if result is not None:
                results.append((worker, result))
        elif time.monotonic() > worker.heartbeat_due:
            results.append((worker, worker.give_up()))
    return results


def _start_worker(work: WorkItem, source: RobotSource, deadline: float) -> Worker:
    worker = Worker(source)
    with suppress(OSError):  # _collect_results() reports a process that has already died
        worker.assign(work, deadline)
    return worker


def _next_work_to(
    workers: list[Worker],
    worker: Worker,
    work: WorkItem | None,
    source: RobotSource,
    deadline: float,
) -> list[Worker]:
    """Give a worker its next work; return the workers that run now.

    If there is no work, the worker is stopped. If its process has ended, a new worker replaces it.
    """
    if not worker.pipe.closed and work is not None:
        try:
            worker.assign(work, deadline)
            return workers
        except OSError:
            pass  # the process died after its last result, so the new work is not the cause
    if not worker.pipe.closed:
        worker.kill()
    other_workers = [other for other in workers if other is not worker]
    return (
        other_workers if work is None else [*other_workers, _start_worker(work, source, deadline)]
    )
