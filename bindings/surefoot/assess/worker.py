"""A process that does one piece of work after the other, and how it is heard."""

from __future__ import annotations

import os
import time
from dataclasses import dataclass
from multiprocessing.connection import Connection
from typing import Any

from surefoot._core import Error
from surefoot.assess.contestant import Contestant
from surefoot.assess.ground import Source
from surefoot.assess.unit import Unit, run_unit
from surefoot.processes import die_with_parent, spawn_context

_START = 120.0  # [s] more for a process that has yet to start and build its plants
_BEAT = None  # sent at the start and after every run; a dictionary is the unit's result
LOST = "lost"  # key of a result that is no result: what has it is tried again by who goes on


@dataclass(frozen=True)
class Work:
    """A unit and who it is for.

    Attributes:
        unit: What to run.
        contestant: Who with.
    """

    unit: Unit
    contestant: Contestant


class Worker:
    """A process, what it is at, and until when it has to be heard.

    Attributes:
        pipe: To it; closed once it has ended.
        work: What it is at, or was.
        until: When it has to be heard at the latest [s] of time.monotonic().
        late: Was it not?
    """

    def __init__(self, source: Source) -> None:
        context = spawn_context()
        self.pipe, theirs = context.Pipe()
        self.process = context.Process(target=_serve, args=(theirs, source), daemon=True)
        self.process.start()
        theirs.close()
        self.work: Work | None = None
        self.until = self._deadline = 0.0
        self.late = self._begun = False

    def give(self, work: Work, deadline: float) -> None:
        """Give it work to do; raises OSError if it has died."""
        self.pipe.send(work)
        first = self.work is None
        self.work, self._deadline = work, deadline * work.unit.patience
        self.until = time.monotonic() + self._deadline + _START * first

    def hear(self) -> dict[str, Any] | None:
        """Return a result if that is what it sent, or what it died with; raises Error."""
        try:
            heard: dict[str, Any] | None = self.pipe.recv()
        except (EOFError, OSError):
            return self._died()
        if heard is _BEAT:
            # The first says that it runs; what it has yet to import and build has time of its own.
            if self._begun:
                self.until = time.monotonic() + self._deadline
            self._begun = True
        return heard

    def give_up(self) -> dict[str, Any]:
        """End one that was not heard in time; return its result."""
        self.end()
        self.late = True
        return _lost(f"never returned: no run ended in {self._deadline:g} s")

    def end(self) -> None:
        """Kill it."""
        self.process.kill()
        self.process.join()
        self.pipe.close()

    def _died(self) -> dict[str, Any]:
        self.process.join()
        code = self.process.exitcode
        self.end()
        if not self._begun:
            raise Error(
                f"a process ended before it had begun, with exit status {code}; expected a main "
                'module that others can import, with all it does under if __name__ == "__main__"'
            ) from None
        return _lost(f"its process died with exit status {code}")


def _lost(why: str) -> dict[str, Any]:
    return {"broken": why, LOST: True}


def _serve(pipe: Connection, source: Source) -> None:
    """Do what comes through the pipe, until it closes."""
    die_with_parent()
    os.dup2(2, 1)  # what a controller prints is no part of our output, which may be JSON
    pipe.send(_BEAT)
    while True:
        try:
            work: Work = pipe.recv()
        except EOFError:
            return
        pipe.send(run_unit(work.unit, source, work.contestant, lambda: pipe.send(_BEAT)))
