"""A process that does one piece of work after the other, and how it is heard."""

from __future__ import annotations

import os
import time
from dataclasses import dataclass
from multiprocessing.connection import Connection
from typing import Any

from surefoot._core import Error
from surefoot.assess.condition_plant import RobotSource
from surefoot.assess.controller_under_test import ControllerUnderTest
from surefoot.assess.work_units import WorkUnit, run_unit
from surefoot.system.worker_processes import die_with_parent, spawn_context

_STARTUP_TIME = 120.0  # [s] more for a process that has yet to start and build its plants
_HEARTBEAT = None  # sent at the start and after every run; a dictionary is the unit's result
LOST_KEY = "lost"  # key of a result that is no result: what has it is tried again by who goes on


@dataclass(frozen=True)
class WorkItem:
    """A unit and who it is for.

    Attributes:
        unit: What to run.
        controller_under_test: Who with.
    """

    unit: WorkUnit
    controller_under_test: ControllerUnderTest


class Worker:
    """A process, what it is at, and until when it has to be heard.

    Attributes:
        pipe: To it; closed once it has ended.
        work: What it is at, or was.
        heartbeat_due: When it has to be heard at the latest [s] of time.monotonic().
        timed_out: Was it not?
    """

    def __init__(self, source: RobotSource) -> None:
        context = spawn_context()
        self.pipe, child_pipe = context.Pipe()
        self.process = context.Process(target=_run_worker, args=(child_pipe, source), daemon=True)
        self.process.start()
        child_pipe.close()
        self.work: WorkItem | None = None
        self.heartbeat_due = self._deadline = 0.0
        self.timed_out = self._started = False

    def assign(self, work: WorkItem, deadline: float) -> None:
        """Give it work to do; raises OSError if it has died."""
        self.pipe.send(work)
        is_first = self.work is None
        self.work, self._deadline = work, deadline * work.unit.deadline_factor
        self.heartbeat_due = time.monotonic() + self._deadline + _STARTUP_TIME * is_first

    def receive(self) -> dict[str, Any] | None:
        """Return a result if that is what it sent, or what it died with; raises Error."""
        try:
            message: dict[str, Any] | None = self.pipe.recv()
        except (EOFError, OSError):
            return self._result_of_death()
        if message is _HEARTBEAT:
            # The first says that it runs; what it has yet to import and build has time of its own.
            if self._started:
                self.heartbeat_due = time.monotonic() + self._deadline
            self._started = True
        return message

    def give_up_leg(self) -> dict[str, Any]:
        """End one that was not heard in time; return its result."""
        self.kill()
        self.timed_out = True
        return _lost_result(f"never returned: no run ended in {self._deadline:g} s")

    def kill(self) -> None:
        """Kill it."""
        self.process.kill()
        self.process.join()
        self.pipe.close()

    def _result_of_death(self) -> dict[str, Any]:
        self.process.join()
        code = self.process.exitcode
        self.kill()
        if not self._started:
            raise Error(
                f"a process ended before it had begun, with exit status {code}; expected a main "
                'module that others can import, with all it does under if __name__ == "__main__"'
            ) from None
        return _lost_result(f"its process died with exit status {code}")


def _lost_result(why: str) -> dict[str, Any]:
    return {"broken": why, LOST_KEY: True}


def _run_worker(pipe: Connection, source: RobotSource) -> None:
    """Do what comes through the pipe, until it closes."""
    die_with_parent()
    os.dup2(2, 1)  # what a controller prints is no part of our output, which may be JSON
    pipe.send(_HEARTBEAT)
    while True:
        try:
            work: WorkItem = pipe.recv()
        except EOFError:
            return
        pipe.send(
            run_unit(work.unit, source, work.controller_under_test, lambda: pipe.send(_HEARTBEAT))
        )
