"""Run of a virtual robot in real time."""

from __future__ import annotations

import math
import signal
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass
from types import FrameType
from typing import Any

from surefoot._core import DdsNetwork
from surefoot.robot.setting_checks import check_number
from surefoot.virtual_robot.dds_robot_link import DdsRobotLink
from surefoot.virtual_robot.keyboard import KEYS_HELP, Keyboard
from surefoot.virtual_robot.real_time_pacer import RealTimePacer
from surefoot.virtual_robot.real_time_priority import RealTimePriority
from surefoot.virtual_robot.robot import VirtualRobot
from surefoot.virtual_robot.run_record import RunRecorder, summarise
from surefoot.virtual_robot.settings import VirtualRobotSettings
from surefoot.virtual_robot.status_line import StatusLine
from surefoot.virtual_robot.udp_port import UdpPort
from surefoot.virtual_robot.viewer import Viewer, check_display

_STATUS_PERIOD = 1.0  # [s] clock time between status lines. Chosen: a person can read them
# [s] Simulated time between updates of keyboard and window. Chosen: the picture is smooth at 50 Hz.
# More frequent updates would slow down the simulation.
_UI_PERIOD = 0.02


@dataclass(frozen=True)
class RunOptions:
    """Address and duration of a run of a virtual robot.

    host and port are for UDP; interface, domain, library, sport_mode and untested_library are for
    DDS.

    Attributes:
        host: Address of this machine at which the robot receives datagrams.
        port: UDP port at which the robot receives datagrams; 0: the system chooses a port.
        duration: Simulated time after which the run ends [s].
        view: True: show the robot in a window; the run ends when the window is closed.
        interface: Network interface, a loopback interface.
        domain: DDS domain, 0 .. 230; 1 is that of unitree_mujoco.
        library: File of libddsc; "": that of the package cyclonedds, else that of the system.
        sport_mode: Mode of the motion switcher at the start; None: there is no motion switcher.
        untested_library: True: a version of libddsc that was not tested is allowed.
    """

    host: str = "127.0.0.1"
    port: int = 8007
    duration: float = math.inf
    view: bool = False
    interface: str = "lo"
    domain: int = 1
    library: str = ""
    sport_mode: str | None = "normal"
    untested_library: bool = False

    def __post_init__(self) -> None:
        check_number("duration", self.duration, 0.001, math.inf)


def run_robot(
    settings: VirtualRobotSettings, options: RunOptions, on_message: Callable[[str], None]
) -> dict[str, Any]:
    """Run a virtual robot in real time, until its duration is over or SIGINT or SIGTERM arrives.

    Args:
        settings: Settings of the robot and its link.
        options: Address, duration and window.
        on_message: Function that receives each line of text for the user: address, status once per
            second, and events.

    Returns:
        Result of summarise() for the run.

    Raises:
        Error: A setting is invalid, a window was requested and there is no display, or the DDS
            network cannot be joined.
        OSError: The port is in use or not permitted.
    """
    generation = settings.generation  # raises Error before any slow step
    if options.view:
        check_display()
    with ExitStack() as stack:
        # Open the port before building the robot: opening fails more often, and building takes a
        # second.
        port, where = _open_port(settings, options, stack)
        robot = VirtualRobot(settings, port, on_message)
        viewer = Viewer(robot.plant) if options.view else None
        if viewer is not None:
            stack.callback(viewer.close)
        keyboard = stack.enter_context(Keyboard(robot.remote))
        stop = stack.enter_context(_StopSignals())
        name = robot.plant.robot.name
        on_message(f"listening on {where} as {name}, {generation}, {settings.pose}")
        if keyboard.is_available:
            on_message(KEYS_HELP)
        on_message(stack.enter_context(RealTimePriority()).granted)
        return _RunLoop(robot, keyboard, viewer).run_until(
            lambda: stop.requested, options.duration, on_message
        )


def _open_port(
    settings: VirtualRobotSettings, options: RunOptions, stack: ExitStack
) -> tuple[UdpPort | DdsRobotLink, str]:
    """Return the open port of a robot, and its address as text."""
    if settings.uses_dds:
        network = DdsNetwork(
            options.interface,
            options.domain,
            library=options.library,
            untested_library=options.untested_library,
        )
        link = DdsRobotLink(network, settings, options.sport_mode)
        return link, ", ".join(network.notices)
    port = UdpPort(options.host, options.port)
    stack.callback(port.close)
    host, bound = port.address
    return port, f"{host}:{bound}"


class _RunLoop:
    """Loop that runs cycles in real time, and updates messages, keyboard and window."""

    def __init__(self, robot: VirtualRobot, keyboard: Keyboard, viewer: Viewer | None) -> None:
        self._robot, self._keyboard, self._viewer = robot, keyboard, viewer
        self._recorder, self._status = RunRecorder(robot), StatusLine(robot)

    def run_until(
        self, stopped: Callable[[], bool], duration: float, on_message: Callable[[str], None]
    ) -> dict[str, Any]:
        robot, period = self._robot, 1.0 / self._robot.settings.rate
        ui_cycles = max(1, round(_UI_PERIOD / period))
        pacer, next_line = RealTimePacer(period), _STATUS_PERIOD
        while not stopped() and robot.time < duration - 1e-9:
            robot.cycle()
            self._recorder.observe()
            self._status.observe()
            slipped = pacer.slipped
            pacer.wait()
            if pacer.slipped > slipped:
                delay_ms = 1000.0 * (pacer.slipped - slipped)
                on_message(
                    f"{robot.time:.3f} s: this machine delayed the robot by {delay_ms:.0f} ms"
                )
            if pacer.cycles % ui_cycles == 0 and not self._update_ui():
                break
            elapsed = pacer.elapsed
            if elapsed >= next_line:
                on_message(self._status.line(elapsed))
                next_line = max(next_line + _STATUS_PERIOD, elapsed)
        return summarise(robot, self._recorder, pacer.real_time_factor, pacer.slipped)

    def _update_ui(self) -> bool:
        """Poll the keyboard and update the window; return False if the window was closed."""
        self._keyboard.poll(self._robot.time)
        if self._viewer is None:
            return True
        self._viewer.show()
        return self._viewer.open


class _StopSignals:
    """Context manager that sets `requested` when SIGINT or SIGTERM arrives; the process goes on."""

    def __init__(self) -> None:
        self.requested = False
        self._previous_handlers: dict[signal.Signals, Any] = {}

    def __enter__(self) -> _StopSignals:
        for signal_number in (signal.SIGINT, signal.SIGTERM):
            self._previous_handlers[signal_number] = signal.signal(
                signal_number, self._request_stop
            )
        return self

    def __exit__(self, *_: object) -> None:
        for signal_number, handler in self._previous_handlers.items():
            signal.signal(signal_number, handler)

    def _request_stop(self, signal_number: int, frame: FrameType | None) -> None:
        self.requested = True
