"""surefoot tune live: serves a page that changes gains of a running robot."""

from __future__ import annotations

import argparse
import signal
import sys
import threading
import webbrowser
from typing import TYPE_CHECKING

from surefoot._core import Error, Gains
from surefoot.cli.graphics import choose_graphics
from surefoot.cli.missing_module import missing_module
from surefoot.cli.robot_choice import (
    add_mjcf_option,
    add_robot_options,
    chosen_robot,
    print_mapping,
)
from surefoot.protocol import default_generation
from surefoot.robot.description import RobotDescription
from surefoot.robot.gain_files import load_gains
from surefoot.robot.loading import build_robot
from surefoot.system.terminal import LinePrinter

if TYPE_CHECKING:
    from surefoot.tune.live.session import Session

# UDP port of the robot if --host gives no port: the low-level port of unitree_legged_sdk.
ROBOT_PORT = 8007


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add every option of surefoot tune live."""
    add_robot_options(parser, "go1")
    add_mjcf_option(parser)
    parser.epilog = (
        "exit status: 0 ended by Ctrl-C or SIGTERM; 1 the port of the page is taken or not "
        "permitted; 2 a wrong argument. The page has no access control: keep --bind at loopback "
        "unless you trust the network"
    )
    add = parser.add_argument
    add("--gains", metavar="FILE.toml", help="initial gains (the robot's own)")
    add("--folder", default=".", metavar="DIR", help="where the page saves and loads gains (.)")
    add(
        "--port",
        type=int,
        default=8080,
        metavar="N",
        help="TCP port of the page; 0: a free one (8080)",
    )
    add("--bind", default="127.0.0.1", metavar="ADDRESS", help="address to serve on (127.0.0.1)")
    add("--open", action="store_true", help="open a browser")
    add("--plain", action="store_true", help="no shadows, for a computer without a GPU")
    group = parser.add_argument_group("robot on UDP instead of a simulated one")
    add = group.add_argument
    text = f"address of the robot, see surefoot run (port {ROBOT_PORT}); gain ranges are limited"
    add("--host", metavar="ADDRESS[:PORT]", help=text)
    add("--sdk", metavar="GENERATION", help="generation of the frames (the robot's newest)")
    add(
        "--power-level",
        type=int,
        metavar="N",
        help="power protection, N x 100 W: 1 .. 10; 0: off (1)",
    )


def run(arguments: argparse.Namespace) -> None:
    """Serve the page until Ctrl-C or SIGTERM.

    Raises:
        Error: A wrong argument.
        OSError: The port of the page is taken or not permitted.
    """
    choose_graphics(pictures=False)
    try:
        from surefoot.tune.live.gain_folder import GainFolder
        from surefoot.tune.live.page import Page
        from surefoot.tune.live.server import close_server, open_server
    except ModuleNotFoundError as problem:
        raise missing_module("tune live", problem, "tune") from None
    description = chosen_robot(arguments, default="go1")
    assert description is not None  # not None, because a default robot is given
    if arguments.mjcf is not None and arguments.host is not None:
        raise Error(f"--mjcf: got it with --host {arguments.host}, expected a simulated robot")
    print_mapping(description)
    own = build_robot(description)
    gains = None if arguments.gains is None else load_gains(arguments.gains, own.config.gains)
    files = GainFolder(arguments.folder, own)
    server = open_server(arguments.bind, arguments.port, f"surefoot tune live: {own.name}")
    stop_event, session = _stop_on_signals(), None
    try:
        session = _open_session(arguments, description, gains)
        page = Page(server, session, files, arguments.plain)
    except BaseException:
        if session is not None:
            session.close()  # end the control of a robot on UDP, which may already stand
        close_server(server)
        raise
    page.start()
    url = f"http://{arguments.bind}:{server.get_port()}"
    LinePrinter(sys.stdout)(f"serving {url} ({own.name}); Ctrl-C ends")
    if arguments.open and not webbrowser.open(url):
        LinePrinter(sys.stderr)(f"--open: no browser could be opened; open {url}")
    try:
        while not stop_event.wait(0.5):  # without a timeout, wait() would block signals
            page.check()
    finally:
        page.stop()


def _open_session(
    arguments: argparse.Namespace, description: RobotDescription, gains: Gains | None
) -> Session:
    if arguments.host is None:
        for option, value in (("--sdk", arguments.sdk), ("--power-level", arguments.power_level)):
            if value is not None:
                raise Error(f"{option}: got {value} without --host, expected both or none")
        from surefoot.tune.live.simulation import Simulation

        return Simulation(description, gains)
    from surefoot.tune.live.control_process import RobotAddress
    from surefoot.tune.live.udp_session import UdpSession

    host, _, port = arguments.host.partition(":")
    if not port:
        port = str(ROBOT_PORT)
    if not port.isdecimal() or not host:
        raise Error(f"--host: got '{arguments.host}', expected ADDRESS or ADDRESS:PORT")
    level = 1 if arguments.power_level is None else arguments.power_level
    if not 0 <= level <= 10:
        raise Error(f"--power-level: got {level}, expected 0 to 10")
    generation = arguments.sdk or default_generation(description.name)
    address = RobotAddress(host, int(port), generation, level)
    return UdpSession(description, address, gains)


def _stop_on_signals() -> threading.Event:
    """Install handlers for SIGINT, SIGTERM and SIGHUP; return the event that they set."""
    stop_event = threading.Event()
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, lambda *_: stop_event.set())
    return stop_event
