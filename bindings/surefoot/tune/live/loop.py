"""The thread that lets a session's time pass as fast as the clock's."""

from __future__ import annotations

import queue
import threading
import time
from collections.abc import Callable
from typing import Any

from surefoot._core import Error
from surefoot.tune.live.session import Session

_NAP = 0.008  # [s] between batches of ticks; finer would only be more to do
_MOST_BEHIND = 0.1  # [s] that is caught up; what goes beyond is lost
_RATED_OVER = 1.0  # [s]
_QUIET = 5.0  # [s] in which the same complaint is not made twice

Action = Callable[[], Any]


class Loop(threading.Thread):
    """Ticks a session in real time, and does between ticks what other threads ask for.

    The session belongs to this thread: whoever wants something of it posts an action.

    Args:
        session: What to tick.
        complain: Is told what an action, or a tick, could not do.

    Attributes:
        paused: Whether time stands still.
        speed: Of the session's time against the clock's; 1 is real time.
        factor: What speed was reached in the last second.
    """

    def __init__(self, session: Session, complain: Callable[[str], None]) -> None:
        super().__init__(name="surefoot tune live", daemon=True)
        self._session, self._complain = session, complain
        self._actions: queue.SimpleQueue[Action] = queue.SimpleQueue()
        self._ending = threading.Event()
        self._steps = 0
        self._said, self._said_at = "", 0.0
        self.paused, self.speed, self.factor = False, 1.0, 1.0

    def post(self, action: Action) -> None:
        """Have something done between two ticks; from any thread."""
        self._actions.put(action)

    def step(self, ticks: int = 1) -> None:
        """Advance by a few ticks while paused; from any thread."""
        self.post(lambda: self._add_steps(ticks))

    def stop(self) -> None:
        """End the thread and wait for it."""
        self._ending.set()
        self.join()

    def run(self) -> None:
        """Tick until stop()."""
        due, former = 0.0, time.monotonic()
        rated, counted = former, 0
        while not self._ending.wait(_NAP):
            self._act()
            now = time.monotonic()
            if self.paused:
                due, count = 0.0, self._steps
            else:
                due = min(due + (now - former) * self.speed, _MOST_BEHIND)
                count = int(due / self._session.period)
                due -= count * self._session.period
            former, self._steps = now, 0
            self._tick(count)
            counted += count
            if now - rated > _RATED_OVER:
                self.factor = counted * self._session.period / (now - rated)
                rated, counted = now, 0

    def _tick(self, count: int) -> None:
        try:
            for _ in range(count):
                self._session.tick()
            self._session.look()
        except Exception as problem:  # this thread must live, whatever went wrong
            # Of a robot that is not simulated here no time can be stopped.
            self.paused = self._session.guard is None
            self._say(problem)

    def _act(self) -> None:
        while not self._actions.empty():
            try:
                self._actions.get()()
            except Exception as problem:
                self._say(problem)

    def _say(self, problem: Exception) -> None:
        text = str(problem)
        if not isinstance(problem, Error | OSError):
            text = f"{type(problem).__name__}: {text}"
        if text == self._said and time.monotonic() - self._said_at < _QUIET:
            return
        self._said, self._said_at = text, time.monotonic()
        self._complain(text)

    def _add_steps(self, ticks: int) -> None:
        self._steps += ticks
