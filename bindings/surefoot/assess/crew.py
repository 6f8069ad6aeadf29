"""Processes with a deadline: one that does not answer in time is killed, and replaced."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from contextlib import suppress
from multiprocessing.connection import wait
from typing import Any

from surefoot.assess.ground import Source
from surefoot.assess.worker import Work, Worker


def run_all(
    works: Iterable[Work], source: Source, jobs: int, deadline: float
) -> Iterator[tuple[Work, dict[str, Any]]]:
    """Run work on several processes; yield what came of each, in the order in which they end.

    A process that dies, or of which nothing is heard for `deadline`, takes the unit that it was at
    with it: {"broken": why, LOST: True}. Another takes its place. Of a contestant that has returned
    before, a unit that was late is tried once more, for machines stall as well.

    Args:
        works: In the order in which they are begun.
        source: The robot.
        jobs: Processes.
        deadline: For one run [s] of wall time.

    Raises:
        Error: Processes cannot be started.
    """
    queue, again = iter(works), list[Work]()
    returned, late = set[str](), set[tuple[str, str]]()
    crew: list[Worker] = []
    try:
        for work in queue:
            crew.append(_begin(work, source, deadline))
            if len(crew) == jobs:
                break
        while crew:
            for worker, result in _heard(crew):
                assert worker.work is not None
                name = worker.work.contestant.name, worker.work.unit.key
                if worker.late and name[0] in returned and name not in late:
                    late.add(name)
                    again.append(worker.work)
                else:
                    yield worker.work, result
                if not worker.pipe.closed:
                    returned.add(name[0])
                more = again.pop() if again else next(queue, None)
                crew = _onward(crew, worker, more, source, deadline)
    finally:
        for worker in crew:
            worker.end()


def _heard(crew: list[Worker]) -> list[tuple[Worker, dict[str, Any]]]:
    """Wait for results, and for those that will never come."""
    left = min(worker.until for worker in crew) - time.monotonic()
    ready = wait([worker.pipe for worker in crew], max(0.0, left))
    done = []
    for worker in crew:
        if worker.pipe in ready:
            result = worker.hear()
            if result is not None:
                done.append((worker, result))
        elif time.monotonic() > worker.until:
            done.append((worker, worker.give_up()))
    return done


def _begin(work: Work, source: Source, deadline: float) -> Worker:
    worker = Worker(source)
    with suppress(OSError):  # who has died by now tells so where it is heard
        worker.give(work, deadline)
    return worker


def _onward(
    crew: list[Worker], worker: Worker, work: Work | None, source: Source, deadline: float
) -> list[Worker]:
    """Give a worker more to do, or let it go; replace it if it is gone."""
    if not worker.pipe.closed and work is not None:
        try:
            worker.give(work, deadline)
            return crew
        except OSError:
            pass  # it has died since its last result: this work is not what it died of
    if not worker.pipe.closed:
        worker.end()
    left = [other for other in crew if other is not worker]
    return left if work is None else [*left, _begin(work, source, deadline)]
