"""Watches a StandRunner's loop: signals and keys to it, lines from it."""

from __future__ import annotations

import select
import signal
import sys
import threading
import time
from collections.abc import Callable

from surefoot._core import RunSnapshot, StandRunner
from surefoot.cli.run_text import Notices, status_line, why_damped
from surefoot.terminal import has_keyboard

_LOOK = 0.02  # [s] between looks at the loop
_LINE = 1.0  # [s] between status lines
_STOPPING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def supervise(runner: StandRunner, say: Callable[[str], None]) -> RunSnapshot:
    """Run the loop in a thread of its own; watch it, the keyboard and signals from this one."""
    loop = threading.Thread(target=runner.run)
    watch = _Watch(runner, say)
    former = {number: signal.signal(number, lambda *_: runner.stop()) for number in _STOPPING}
    former[signal.SIGUSR1] = signal.signal(signal.SIGUSR1, lambda *_: watch.rearm())
    loop.start()
    try:
        while loop.is_alive():
            time.sleep(_LOOK)
            watch.look(runner.snapshot())
    finally:
        runner.stop()
        loop.join()
        for number, handler in former.items():
            signal.signal(number, handler)
    return runner.snapshot()


class _Watch:
    """Says what changes, and how it is once a second."""

    def __init__(self, runner: StandRunner, say: Callable[[str], None]) -> None:
        self._runner, self._say = runner, say
        self._notices = Notices(say)
        self._keys = has_keyboard()
        self._said, self._phase = time.monotonic(), ""
        self._refused = self._pauses = 0

    def rearm(self) -> None:
        """Ask for it; the loop says no while no LowState comes."""
        self._runner.rearm()

    def look(self, now: RunSnapshot) -> None:
        """Look at keys and loop."""
        if self._keys and select.select([sys.stdin], [], [], 0.0)[0]:
            line = sys.stdin.readline()
            self._keys = bool(line)  # else its end
            if line.strip() == "r":
                self.rearm()
        self._notices.look(now)
        if now.refused_rearms > self._refused:
            self._refused = now.refused_rearms
            self._say(f"{now.time:7.2f} s not re-armed: no LowState for {1000 * now.age:.0f} ms")
        if now.pauses > self._pauses:
            self._pauses = now.pauses
            self._say(f"{now.time:7.2f} s going on: the robot's clock had stood still as well")
        if now.phase != self._phase and now.time > 0.0:
            if not self._phase:
                self._say(self._runner.real_time)
            self._phase = now.phase
            why = f": {why_damped(now)}; r + Enter re-arms" if now.phase == "damping" else ""
            self._say(f"{now.time:7.2f} s {now.phase}{why}")
        if time.monotonic() - self._said > _LINE:
            self._said = time.monotonic()
            self._say(status_line(now))
