"""Processes with a deadline: one that does not answer in time is killed, and replaced."""

from __future__ import annotations

import os
import time
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from typing import Any

from surefoot.assess.contestant import Contestant
from surefoot.assess.ground import Source
from surefoot.assess.unit import Unit, run_unit
from surefoot.processes import die_with_parent, spawn_context

_START = 120.0  # [s] more for a process that has yet to start and build its plants
_BEAT = None  # sent before the first and after every run; a dictionary is the unit's result


@dataclass(frozen=True)
class Work:
    """A unit and who it is for.

    Attributes:
        unit: What to run.
        contestant: Who with.
    """

    unit: Unit
    contestant: Contestant


class _Worker:
    """A process, what it is at, and until when it has to be heard."""

    def __init__(self, source: Source) -> None:
        context = spawn_context()
        self.pipe, theirs = context.Pipe()
        self.process = context.Process(target=_serve, args=(theirs, source), daemon=True)
        self.process.start()
        theirs.close()
        self.work: Work | None = None
        self.until = self.deadline = 0.0
        self.fresh, self.late = True, False

    def give(self, work: Work, deadline: float) -> None:
        self.pipe.send(work)
        self.work, self.deadline = work, deadline * work.unit.patience
        self.until = time.monotonic() + self.deadline + _START * self.fresh
        self.fresh = False

    def beat(self) -> None:
        self.until = time.monotonic() + self.deadline

    def end(self) -> None:
        self.process.kill()
        self.process.join()
        self.pipe.close()


def run_all(
    works: Iterable[Work], source: Source, jobs: int, deadline: float
) -> Iterator[tuple[Work, dict[str, Any]]]:
    """Run work on several processes; yield what came of each, in the order in which they end.

    A process that dies, or of which nothing is heard for `deadline`, takes the unit that it was at
    with it: {"broken": why}. Another takes its place. Of a contestant that has returned before, a
    unit that was late is tried once more, for machines stall as well.

    Args:
        works: In the order in which they are begun.
        source: The robot.
        jobs: Processes.
        deadline: For one run [s] of wall time.
    """
    queue, again = iter(works), list[Work]()
    returned, late = set[str](), set[tuple[str, str]]()
    crew: list[_Worker] = []
    try:
        for work in queue:
            crew.append(_Worker(source))
            crew[-1].give(work, deadline)
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


def _heard(crew: list[_Worker]) -> list[tuple[_Worker, dict[str, Any]]]:
    """Wait for results, and for those that will never come."""
    left = min(worker.until for worker in crew) - time.monotonic()
    ready = wait([worker.pipe for worker in crew], max(0.0, left))
    done = []
    for worker in crew:
        if worker.pipe in ready:
            result = _receive(worker)
            if result is _BEAT:
                worker.beat()
            else:
                done.append((worker, result))
        elif time.monotonic() > worker.until:
            worker.end()
            worker.late = True
            done.append(
                (worker, {"broken": f"never returned: no run ended in {worker.deadline:g} s"})
            )
    return done


def _receive(worker: _Worker) -> Any:
    try:
        return worker.pipe.recv()
    except (EOFError, OSError):
        worker.process.join()
        code = worker.process.exitcode
        worker.end()
        return {"broken": f"its process died with exit status {code}"}


def _onward(
    crew: list[_Worker], worker: _Worker, work: Work | None, source: Source, deadline: float
) -> list[_Worker]:
    """Give a worker more to do, or let it go; replace it if it is gone."""
    if worker.pipe.closed or work is None:
        if not worker.pipe.closed:
            worker.end()
        crew = [other for other in crew if other is not worker]
        if work is not None:
            crew.append(_Worker(source))
            crew[-1].give(work, deadline)
        return crew
    worker.give(work, deadline)
    return crew


def _serve(pipe: Connection, source: Source) -> None:
    """Do what comes through the pipe, until it closes."""
    die_with_parent()
    os.dup2(2, 1)  # what a controller prints is no part of our output, which may be JSON
    while True:
        try:
            work: Work = pipe.recv()
        except EOFError:
            return
        pipe.send(run_unit(work.unit, source, work.contestant, lambda: pipe.send(_BEAT)))
