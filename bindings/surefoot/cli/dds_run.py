"""surefoot run over DDS: joins the network, releases the sport service and opens the link."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable

from surefoot._core import DdsLink, DdsNetwork, Error
from surefoot.cli.dds_options import DEFAULT_DOMAIN, add_dds_options
from surefoot.motion_switcher import MotionSwitcher
from surefoot.system.terminal import has_keyboard

REAL_DOMAIN = 0  # of real robots


def add_dds_run_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of surefoot run that are for DDS only."""
    group = parser.add_argument_group("DDS (--sdk go2 or b2)")
    add_dds_options(group)
    add = group.add_argument
    add(
        "--tick",
        choices=("message", "arrival"),
        default="message",
        help="arrival: where the tick of the LowStates stands at 0, make it from their arrival",
    )
    add(
        "--no-motion-switcher",
        action="store_true",
        help="simulation only: do not release the sport service, because nobody answers",
    )
    add(
        "--give-back",
        action="store_true",
        help="at the end, when the robot lies, activate the mode of the sport service again",
    )


class DdsSession:
    """Network, released sport service and link of one run.

    Args:
        arguments: Arguments of surefoot run.
        damping_kd: kd in the damping commands that the link itself sends [N.m.s/rad].
        print_line: Called with each line for the operator.

    Raises:
        Error: The network cannot be joined, no motion switcher answers and the operator does not
            confirm, or the link cannot be opened.

    Attributes:
        link: The open link.
    """

    def __init__(
        self, arguments: argparse.Namespace, damping_kd: float, print_line: Callable[[str], None]
    ) -> None:
        self._real, self._give_back = arguments.real_robot, arguments.give_back
        self._print_line = print_line
        domain = REAL_DOMAIN if self._real else DEFAULT_DOMAIN
        self._network = DdsNetwork(
            arguments.interface,
            domain if arguments.domain is None else arguments.domain,
            self._real,
            arguments.libddsc,
        )
        for line in self._network.notices:
            print_line(line)
        self._switcher: MotionSwitcher | None = None
        self._mode = ""  # mode of the sport service that was released
        if arguments.no_motion_switcher:
            self._check_simulation()
        else:
            self._release()
        self.link = DdsLink(self._network, arguments.sdk, damping_kd, tick=arguments.tick)

    def end(self, lies: bool) -> None:
        """Activate the mode of the sport service again, if this was requested.

        Args:
            lies: Whether the robot lies; a robot that does not lie keeps its present mode.
        """
        if not (self._give_back and self._mode and self._switcher):
            return
        if not lies:
            self._print_line("--give-back: the robot does not lie; its sport service stays off")
            return
        try:
            self._switcher.select_mode(self._mode)
        except Error as problem:
            self._print_line(f"--give-back: {problem}")
        else:
            self._print_line(f"motion switcher: mode '{self._mode}' is active again")

    def _check_simulation(self) -> None:
        if self._real:
            raise Error(
                "--no-motion-switcher: got --real-robot, expected a simulation: on a robot the "
                "sport service must be released, or both programs command the motors"
            )

    def _release(self) -> None:
        switcher = MotionSwitcher(self._network)
        if not switcher.is_present():
            self._confirm_without_switcher()
            return
        self._switcher = switcher
        if self._real and switcher.check_mode():
            _ask(
                "the sport service is active: let the robot lie down with its remote, because its "
                "legs give way when the service ends. Type lies + Enter when it lies: ",
                "lies",
            )
        self._mode = switcher.release(self._print_line)
        self._print_line("motion switcher: no mode is active, the low level is free")

    def _confirm_without_switcher(self) -> None:
        if not self._real:
            raise Error(
                "motion switcher: got no answer, expected one; check --domain and --interface, or "
                "use --no-motion-switcher for a simulator that has none"
            )
        _ask(
            "no motion switcher answers, so it is not known whether the sport service is off. Is "
            "it off? Type off + Enter: ",
            "off",
        )


def _ask(question: str, answer: str) -> None:
    """Ask the operator; raise Error if the answer is another one or nobody can answer."""
    if not has_keyboard():
        raise Error(f"got no terminal for the answer, expected one: {question}")
    print(question, end="", flush=True, file=sys.stderr)
    typed = sys.stdin.readline().strip().lower()
    if typed != answer:
        raise Error(f"got the answer '{typed}', expected '{answer}': the run does not begin")
