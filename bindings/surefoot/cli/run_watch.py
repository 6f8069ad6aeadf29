"""Watches a StandRunner's loop: signals and keys to it, lines from it."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Callable

from surefoot._core import Robot, RunSnapshot, StandRunner
from surefoot.cli.run_operator import Operator, Readiness
from surefoot.cli.run_text import Faults, Notices, status_line, why_damped
from surefoot.cli.run_unasked import UnaskedRise

_LOOK = 0.02  # [s] between looks at the loop
_LINE = 1.0  # [s] between status lines
_STUCK = 0.5  # [s] without a look, after which what was typed is of another time
_STOPPING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def supervise(
    runner: StandRunner,
    robot: Robot,
    say: Callable[[str], None],
    rise: bool = False,
    unasked: bool = False,
) -> RunSnapshot:
    """Run the loop in a thread of its own; watch it, the keyboard and signals from this one.

    Args:
        runner: The loop.
        robot: What it runs on, for names and limits.
        say: Called with lines for people.
        rise: The robot is to get up: say what keeps it from being armed.
        unasked: Arm and rise without being asked, once all checks pass.
    """
    loop = threading.Thread(target=runner.run)
    watch = _Watch(runner, robot, rise, say)
    readiness = Readiness(robot, say) if rise else None
    unasked_rise = UnaskedRise(runner) if unasked else None
    former = {number: signal.signal(number, lambda *_: watch.end()) for number in _STOPPING}
    former[signal.SIGUSR1] = signal.signal(signal.SIGUSR1, lambda *_: runner.rearm())
    former[signal.SIGQUIT] = signal.signal(signal.SIGQUIT, lambda *_: runner.stop())
    loop.start()
    try:
        while loop.is_alive():
            time.sleep(_LOOK)
            runner.heartbeat()
            watch.forget_old_keys()
            now = runner.snapshot()
            if unasked_rise:
                unasked_rise.look(now)
            due = watch.look(now)
            if readiness and now.time > 0.0:
                readiness.look(now, due)
    finally:
        runner.stop()
        loop.join()
        for number, handler in former.items():
            signal.signal(number, handler)
    return runner.snapshot()


class _Watch:
    """Says what changes, and how it is once a second."""

    def __init__(
        self, runner: StandRunner, robot: Robot, rise: bool, say: Callable[[str], None]
    ) -> None:
        self._runner, self._say = runner, say
        self._notices, self._faults = Notices(say), Faults(say)
        self._operator = Operator(runner, robot, rise, say)
        self._said = self._looked = time.monotonic()
        self._phase = ""
        self._refused = self._pauses = 0
        self._stuck = self._ending = False

    def end(self) -> None:
        """Sit down, then damp, and end; asked again, damp at once."""
        if self._ending:
            self._runner.stop()
        self._ending = True
        self._runner.finish()

    def forget_old_keys(self) -> None:
        """Leave out what was typed while this program was stuck: it was meant for then."""
        stuck = time.monotonic() - self._looked
        self._looked = time.monotonic()
        if stuck > _STUCK and self._operator.forget():
            self._say(f"stuck for {stuck:.1f} s: keys typed meanwhile are left out")

    def look(self, now: RunSnapshot) -> bool:
        """Look at keys and loop; return whether a status line was due."""
        self._operator.look(now)
        self._notices.look(now)
        self._say_counts(now)
        if now.phase != self._phase and now.time > 0.0:
            if not self._phase:
                self._say(self._runner.real_time)
            self._phase = now.phase
            why = f": {why_damped(now)}; a + Enter arms again" if now.phase == "damping" else ""
            self._say(f"{now.time:7.2f} s {now.phase}{why}")
        self._faults.look(now)
        due = time.monotonic() - self._said > _LINE
        if due:
            self._said = time.monotonic()
            self._say(status_line(now))
        return due

    def _say_counts(self, now: RunSnapshot) -> None:
        if now.refused_rearms > self._refused:
            self._refused = now.refused_rearms
            silent = now.age > _LOOK
            why = f"no LowState for {1000 * now.age:.0f} ms" if silent else "arming checks fail"
            self._say(f"{now.time:7.2f} s not re-armed: {why}")
        if now.pauses > self._pauses:
            self._pauses = now.pauses
            self._say(f"{now.time:7.2f} s going on: the robot's clock had stood still as well")
        if now.stuck and not self._stuck:
            self._say(f"{now.time:7.2f} s the rise gave up: a leg or the body could not follow")
        self._stuck = now.stuck
