"""Thread that ticks a session in real time."""

from __future__ import annotations

import queue
import threading
import time
from collections.abc import Callable
from typing import Any

from surefoot._core import Error
from surefoot.tune.live.session import Session

# Chosen: four ticks at 500 Hz; short against FRAME_PERIOD of the page, 33 ms.
_SLEEP_TIME = 0.008  # [s] time between two batches of ticks
# Chosen: three frames of the page; a longer stall would make the simulation run fast to catch up.
_MAX_LAG = 0.1  # [s] longest lag behind the clock that is caught up; the rest is dropped
_RATE_WINDOW = 1.0  # [s] time over which real_time_factor is measured
_REPEAT_TIME = 5.0  # [s] shortest time between two notifications of the same error

Action = Callable[[], Any]


class SessionThread(threading.Thread):
    """Thread that owns a session: it ticks the session and runs actions between ticks.

    Other threads call post() instead of the session's methods, except for methods whose docstrings
    permit any thread.

    Args:
        session: Session to tick.
        show_error: Called with the error text of a failed action or tick.

    Attributes:
        paused: True while the session's time stands still; may be set.
        speed: Desired ratio of session time to clock time; 1 is real time.
        real_time_factor: Measured ratio of session time to clock time in the last second.
    """

    def __init__(self, session: Session, show_error: Callable[[str], None]) -> None:
        super().__init__(name="surefoot tune live", daemon=True)
        self._session, self._show_error = session, show_error
        self._actions: queue.SimpleQueue[Action] = queue.SimpleQueue()
        self._stop_event = threading.Event()
        self._steps = 0
        self._last_text, self._last_text_time = "", 0.0
        self.paused, self.speed, self.real_time_factor = False, 1.0, 1.0

    def post(self, action: Action) -> None:
        """Queue an action, which this thread runs between two ticks.

        Callable from any thread; returns at once.
        """
        self._actions.put(action)

    def step(self, ticks: int = 1) -> None:
        """Advance by a few ticks while paused; callable from any thread."""
        self.post(lambda: self._add_steps(ticks))

    def stop(self) -> None:
        """End the thread and wait for it."""
        self._stop_event.set()
        self.join()

    def run(self) -> None:
        """Tick until stop()."""
        owed_time, last_time = 0.0, time.monotonic()
        window_start, window_ticks = last_time, 0
        while not self._stop_event.wait(_SLEEP_TIME):
            self._run_actions()
            now = time.monotonic()
            if self.paused:
                owed_time, count = 0.0, self._steps
            else:
                owed_time = min(owed_time + (now - last_time) * self.speed, _MAX_LAG)
                count = int(owed_time / self._session.period)
                owed_time -= count * self._session.period
            last_time, self._steps = now, 0
            self._tick(count)
            window_ticks += count
            if now - window_start > _RATE_WINDOW:
                self.real_time_factor = window_ticks * self._session.period / (now - window_start)
                window_start, window_ticks = now, 0

    def _tick(self, count: int) -> None:
        try:
            for _ in range(count):
                self._session.tick()
            self._session.update_view()
        except Exception as problem:  # no error may end this thread
            # Pause only a simulation: the time of a robot on UDP cannot be paused.
            self.paused = self._session.gain_limiter is None
            self._show_problem(problem)

    def _run_actions(self) -> None:
        while not self._actions.empty():
            try:
                self._actions.get()()
            except Exception as problem:
                self._show_problem(problem)

    def _show_problem(self, problem: Exception) -> None:
        text = str(problem)
        if not isinstance(problem, Error | OSError):
            text = f"{type(problem).__name__}: {text}"
        if text == self._last_text and time.monotonic() - self._last_text_time < _REPEAT_TIME:
            return
        self._last_text, self._last_text_time = text, time.monotonic()
        self._show_error(text)

    def _add_steps(self, ticks: int) -> None:
        self._steps += ticks
