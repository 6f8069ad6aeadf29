"""Supervision of a Runner: passes signals and keys to its loop and prints its state."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Callable

from surefoot._core import RequestStatus, Robot, Runner, RunSnapshot
from surefoot.cli.automatic_rise import AutomaticRise
from surefoot.cli.run_operator import ArmingMonitor, Operator
from surefoot.cli.run_text import FaultMonitor, LinkWarnings, status_line
from surefoot.reports.damping_reason import damping_reason
from surefoot.reports.refusal_reason import refusal_reason

# [s] Time between two snapshots of the loop. Chosen: shorter than the 0.05 s after which the loop
# publishes a new snapshot (kPublishPeriod).
_POLL_PERIOD = 0.02
# Chosen for a person.
_STATUS_PERIOD = 1.0  # [s] time between two status lines
# [s] Time between two polls above which typed keys are discarded. Chosen: longer than the delays
# that a loaded machine causes. With a larger value, a key could act unexpectedly late.
_STUCK_TIME = 0.5
_STOP_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def supervise(
    runner: Runner,
    robot: Robot,
    print_line: Callable[[str], None],
    rise: bool = False,
    automatic: bool = False,
    take_news: Callable[[], list[str]] | None = None,
) -> RunSnapshot:
    """Run the control loop in its own thread; poll loop, keyboard and signals from this thread.

    SIGINT, SIGTERM and SIGHUP finish the run: see Runner.finish(). A second one of these
    signals damps at once. SIGUSR1 arms again. SIGQUIT damps at once.

    Args:
        runner: The control loop.
        robot: The robot that the loop controls, for names and limits.
        print_line: Called with each line for the operator.
        rise: Whether the robot starts lying. If true, failing arming checks are printed.
        automatic: Whether to arm and rise once, as soon as all checks pass, without a key press.
        take_news: Returns news about the link since its last call, as sentences; None: no news.

    Returns:
        The last snapshot of the runner.
    """
    loop = threading.Thread(target=runner.run)
    monitor = _RunMonitor(runner, robot, rise, print_line)
    arming_monitor = ArmingMonitor(robot, print_line) if rise else None
    automatic_rise = AutomaticRise(runner) if automatic else None
    old_handlers = {
        number: signal.signal(number, lambda *_: monitor.end()) for number in _STOP_SIGNALS
    }
    old_handlers[signal.SIGUSR1] = signal.signal(signal.SIGUSR1, lambda *_: runner.rearm())
    old_handlers[signal.SIGQUIT] = signal.signal(signal.SIGQUIT, lambda *_: runner.stop())
    loop.start()
    try:
        while loop.is_alive():
            time.sleep(_POLL_PERIOD)
            runner.heartbeat()
            monitor.discard_stale_keys()
            snapshot = runner.snapshot()
            if automatic_rise:
                automatic_rise.update(snapshot)
            for news in take_news() if take_news else ():
                print_line(f"{snapshot.time:7.2f} s {news}")
            due = monitor.update(snapshot)
            if arming_monitor and snapshot.time > 0.0:
                arming_monitor.update(snapshot, due)
    finally:
        runner.stop()
        loop.join()
        for number, handler in old_handlers.items():
            signal.signal(number, handler)
    return runner.snapshot()


class _RunMonitor:
    """Printer of changes of the robot's state, and of one status line per second."""

    def __init__(
        self, runner: Runner, robot: Robot, rise: bool, print_line: Callable[[str], None]
    ) -> None:
        self._runner, self._print_line = runner, print_line
        self._link_warnings, self._fault_monitor = (
            LinkWarnings(print_line),
            FaultMonitor(print_line),
        )
        self._operator = Operator(runner, robot, rise, print_line)
        self._last_status_time = self._last_poll_time = time.monotonic()
        self._phase = ""
        self._refused = self._resumed_dampings = 0
        self._rise_failed = self._ending = False

    def end(self) -> None:
        """Finish the run, see Runner.finish(); a second call damps at once."""
        if self._ending:
            self._runner.stop()
        self._ending = True
        self._runner.finish()

    def discard_stale_keys(self) -> None:
        """Discard keys typed while this thread was stuck, because the robot's state may differ."""
        stuck = time.monotonic() - self._last_poll_time
        self._last_poll_time = time.monotonic()
        if stuck > _STUCK_TIME and self._operator.discard_typed():
            self._print_line(f"stalled for {stuck:.1f} s: keys typed meanwhile are ignored")

    def update(self, snapshot: RunSnapshot) -> bool:
        """Handle keys and print changes; return whether a status line was printed."""
        self._operator.update(snapshot)
        self._link_warnings.update(snapshot)
        self._print_counts(snapshot)
        if snapshot.phase != self._phase and snapshot.time > 0.0:
            if not self._phase:
                self._print_line(self._runner.real_time)
            self._phase = snapshot.phase
            why = (
                f": {damping_reason(snapshot)}; a + Enter arms again"
                if snapshot.phase == "damping"
                else ""
            )
            self._print_line(f"{snapshot.time:7.2f} s {snapshot.phase}{why}")
        self._fault_monitor.update(snapshot)
        due = time.monotonic() - self._last_status_time > _STATUS_PERIOD
        if due:
            self._last_status_time = time.monotonic()
            self._print_line(status_line(snapshot))
        return due

    def _print_counts(self, snapshot: RunSnapshot) -> None:
        if snapshot.refused_rearms > self._refused:
            self._refused = snapshot.refused_rearms
            silent = snapshot.state_age > _POLL_PERIOD
            why = (
                f"no LowState for {1000 * snapshot.state_age:.0f} ms"
                if silent
                else refusal_reason(RequestStatus.NOT_READY, snapshot)
            )
            self._print_line(f"{snapshot.time:7.2f} s not re-armed: {why}")
        if snapshot.resumed_dampings > self._resumed_dampings:
            self._resumed_dampings = snapshot.resumed_dampings
            self._print_line(
                f"{snapshot.time:7.2f} s resumed: the robot's clock paused while it was silent"
            )
        if snapshot.rise_failed and not self._rise_failed:
            self._print_line(
                f"{snapshot.time:7.2f} s rise given up: a leg or the body did not follow"
            )
        self._rise_failed = snapshot.rise_failed
