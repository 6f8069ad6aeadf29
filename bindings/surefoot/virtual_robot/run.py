"""A virtual robot in real time, from its start to its record."""

from __future__ import annotations

import math
import signal
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass
from types import FrameType
from typing import Any

from surefoot.sim.checks import number
from surefoot.virtual_robot.clock import RealTime
from surefoot.virtual_robot.keyboard import KEYS, Keyboard
from surefoot.virtual_robot.port import UdpPort
from surefoot.virtual_robot.priority import RealTimePriority
from surefoot.virtual_robot.record import Recorder, summarise
from surefoot.virtual_robot.robot import VirtualRobot
from surefoot.virtual_robot.settings import VirtualRobotSettings
from surefoot.virtual_robot.status_line import StatusLine
from surefoot.virtual_robot.viewer import Viewer, check_display

_STATUS_PERIOD = 1.0  # [s] by the clock
_GLANCE_PERIOD = 0.02  # [s] simulated, between looks at keyboard and window


@dataclass(frozen=True)
class RunOptions:
    """Where and how long a virtual robot runs.

    Attributes:
        host: Address to listen on.
        port: Port to listen on; 0 lets the system choose.
        duration: Simulated time after which it ends by itself [s].
        view: Show it in a window; closing the window ends the run.
    """

    host: str = "127.0.0.1"
    port: int = 8007
    duration: float = math.inf
    view: bool = False

    def __post_init__(self) -> None:
        number("duration", self.duration, 0.001, math.inf)


def run_robot(
    settings: VirtualRobotSettings, options: RunOptions, say: Callable[[str], None]
) -> dict[str, Any]:
    """Run a virtual robot until its time is over, SIGINT or SIGTERM; return its record.

    Args:
        settings: What it is asked to be.
        options: Where and how long.
        say: Called with lines for people: where it listens, one a second, what happens.

    Raises:
        Error: What cannot be, from robot to display.
        OSError: The port cannot be had.
    """
    generation = settings.generation  # raises before anything takes time
    if options.view:
        check_display()
    with ExitStack() as stack:
        # The port first: it is what fails most, and robots take a second to build.
        port = UdpPort(options.host, options.port)
        stack.callback(port.close)
        robot = VirtualRobot(settings, port, say)
        viewer = Viewer(robot.plant) if options.view else None
        if viewer is not None:
            stack.callback(viewer.close)
        keyboard = stack.enter_context(Keyboard(robot.remote))
        stop = stack.enter_context(_StopSignals())
        host, bound = port.address
        name = robot.plant.robot.name
        say(f"listening on {host}:{bound} as {name}, {generation}, {settings.pose}")
        if keyboard.present:
            say(KEYS)
        say(stack.enter_context(RealTimePriority()).got)
        return _Run(robot, keyboard, viewer).until(lambda: stop.asked, options.duration, say)


class _Run:
    """The loop."""

    def __init__(self, robot: VirtualRobot, keyboard: Keyboard, viewer: Viewer | None) -> None:
        self._robot, self._keyboard, self._viewer = robot, keyboard, viewer
        self._recorder, self._status = Recorder(robot), StatusLine(robot)

    def until(
        self, stopped: Callable[[], bool], duration: float, say: Callable[[str], None]
    ) -> dict[str, Any]:
        robot, period = self._robot, 1.0 / self._robot.settings.rate
        glance = max(1, round(_GLANCE_PERIOD / period))
        clock, next_line = RealTime(period), _STATUS_PERIOD
        while not stopped() and robot.time < duration - 1e-9:
            robot.cycle()
            self._recorder.observe()
            self._status.observe()
            slipped = clock.slipped
            clock.wait()
            if clock.slipped > slipped:
                held = 1000.0 * (clock.slipped - slipped)
                say(f"{robot.time:.3f} s: this machine held the robot up for {held:.0f} ms")
            if clock.cycles % glance == 0 and not self._glance():
                break
            elapsed = clock.elapsed
            if elapsed >= next_line:
                say(self._status.line(elapsed))
                next_line = max(next_line + _STATUS_PERIOD, elapsed)
        return summarise(robot, self._recorder, clock.factor, clock.slipped)

    def _glance(self) -> bool:
        """Look at keyboard and window; return whether the window is not closed."""
        self._keyboard.poll(self._robot.time)
        if self._viewer is None:
            return True
        self._viewer.show()
        return self._viewer.open


class _StopSignals:
    """Ctrl-C and SIGTERM ask the loop to end instead of ending the process."""

    def __init__(self) -> None:
        self.asked = False
        self._before: dict[signal.Signals, Any] = {}

    def __enter__(self) -> _StopSignals:
        for which in (signal.SIGINT, signal.SIGTERM):
            self._before[which] = signal.signal(which, self._ask)
        return self

    def __exit__(self, *_: object) -> None:
        for which, handler in self._before.items():
            signal.signal(which, handler)

    def _ask(self, which: int, frame: FrameType | None) -> None:
        self.asked = True
