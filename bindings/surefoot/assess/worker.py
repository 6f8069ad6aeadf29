"""Worker process that runs units one after another, and the supervision of its heartbeats."""

from __future__ import annotations

import os
import time
from dataclasses import dataclass
from multiprocessing.connection import Connection
from typing import Any

from surefoot._core import Error
from surefoot.assess.controller_under_test import ControllerUnderTest
from surefoot.assess.robot_source import RobotSource
from surefoot.assess.work_units import WorkUnit, run_unit
from surefoot.system.worker_processes import die_with_parent, spawn_context

# [s] Time added to the first deadline, because a new process imports modules and builds plants.
# Chosen: this takes seconds on a free machine, and longer on a busy one or from a network disk.
_STARTUP_TIME = 120.0
# Message that a process sends at its start and after every run. Any other message is the result of
# a unit.
_HEARTBEAT = None
LOST_KEY = "lost"  # key in the result of a unit that did not end; a resumed run repeats the unit


@dataclass(frozen=True)
class WorkItem:
    """A unit and the controller that runs it.

    Attributes:
        unit: Unit of work.
        controller_under_test: Controller for the unit.
    """

    unit: WorkUnit
    controller_under_test: ControllerUnderTest


class Worker:
    """A worker process, its current work, and the time by which its next heartbeat is due.

    Attributes:
        pipe: Connection to the process; closed after the process has ended.
        work: Current or last work; None before the first work.
        heartbeat_due: Time of time.monotonic() by which the next message must arrive [s].
        timed_out: True if the process was killed because no message arrived by `heartbeat_due`.
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
        """Send work to the process.

        Args:
            work: The work.
            deadline: Longest wall time of one run [s]; multiplied by the unit's deadline_factor.

        Raises:
            OSError: The process has died.
        """
        self.pipe.send(work)
        is_first = self.work is None
        self.work, self._deadline = work, deadline * work.unit.deadline_factor
        self.heartbeat_due = time.monotonic() + self._deadline + _STARTUP_TIME * is_first

    def receive(self) -> dict[str, Any] | None:
        """Read a message from the process.

        Returns:
            The result of a unit, or None after a heartbeat. If the process has died: a result with
            the keys "broken" and LOST_KEY.

        Raises:
            Error: The process ended before its first heartbeat.
        """
        try:
            message: dict[str, Any] | None = self.pipe.recv()
        except (EOFError, OSError):
            return self._result_of_death()
        if message is _HEARTBEAT:
            # The first heartbeat does not change the due time: the process may still build a plant.
            if self._started:
                self.heartbeat_due = time.monotonic() + self._deadline
            self._started = True
        return message

    def give_up(self) -> dict[str, Any]:
        """Kill a process that missed its heartbeat; return the result for its lost unit."""
        self.kill()
        self.timed_out = True
        return _lost_result(f"never returned: no run ended in {self._deadline:g} s")

    def kill(self) -> None:
        """Kill the process and close its pipe."""
        self.process.kill()
        self.process.join()
        self.pipe.close()

    def _result_of_death(self) -> dict[str, Any]:
        self.process.join()
        code = self.process.exitcode
        self.kill()
        if not self._started:
            raise Error(
                f"a worker process ended at its start with exit status {code}; expected a main "
                'module that can be imported, with its code under if __name__ == "__main__"'
            ) from None
        return _lost_result(f"its process died with exit status {code}")


def _lost_result(why: str) -> dict[str, Any]:
    return {"broken": why, LOST_KEY: True}


def _run_worker(pipe: Connection, source: RobotSource) -> None:
    """Run the work items from the pipe until it closes."""
    die_with_parent()
    os.dup2(2, 1)  # stdout of the main process may carry JSON, so controllers print to stderr
    pipe.send(_HEARTBEAT)
    while True:
        try:
            work: WorkItem = pipe.recv()
        except EOFError:
            return
        pipe.send(
            run_unit(work.unit, source, work.controller_under_test, lambda: pipe.send(_HEARTBEAT))
        )
