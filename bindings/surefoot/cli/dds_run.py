"""surefoot run over DDS: joins the network, releases the sport service and opens the link."""

from __future__ import annotations

import argparse
import sys
import termios
from collections.abc import Callable
from types import TracebackType

from surefoot._core import DdsLink, DdsNetwork, Error, Mode, RunSnapshot
from surefoot.cli.dds_options import DEFAULT_DOMAIN, LOOPBACK, add_dds_options
from surefoot.motion_switcher import MotionSwitcher
from surefoot.system.terminal import has_keyboard

REAL_DOMAIN = 0  # of real robots


def add_dds_run_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of surefoot run that are for DDS only."""
    group = parser.add_argument_group("DDS (--sdk go2 or b2)")
    add_dds_options(group, f"network interface ({LOOPBACK}; --real-robot: required)")
    add = group.add_argument
    add(
        "--tick",
        choices=("message", "arrival"),
        help="arrival: where the tick of the LowStates stands at 0, make it from their arrival "
        "(message)",
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
    """Network and released sport service of one run; a context manager.

    Entering the context releases the sport service. If the block raises, the session prints that
    the sport service is off. With --give-back it activates the mode again instead, if the robot has
    not moved.

    Args:
        arguments: Arguments of surefoot run.
        print_line: Called with each line for the operator.

    Raises:
        Error: The network cannot be joined.
    """

    def __init__(self, arguments: argparse.Namespace, print_line: Callable[[str], None]) -> None:
        self._arguments, self._print_line = arguments, print_line
        self._real, self._give_back = arguments.real_robot, arguments.give_back
        domain = REAL_DOMAIN if self._real else DEFAULT_DOMAIN
        self._network = DdsNetwork(
            arguments.interface or LOOPBACK,
            domain if arguments.domain is None else arguments.domain,
            self._real,
            arguments.libddsc or "",
            arguments.untested_libddsc,
        )
        for line in self._network.notices:
            print_line(line)
        self._switcher: MotionSwitcher | None = None
        self._mode = ""  # mode that was released and not given back
        self._release_sent = self._may_have_moved = False

    def __enter__(self) -> DdsSession:
        """Release the sport service.

        Raises:
            Error: No motion switcher answers and the operator does not confirm, the operator does
                not confirm that the robot lies, or the switcher does not release the mode.
        """
        if not self._arguments.no_motion_switcher:
            try:
                self._release()
            except BaseException:
                if self._release_sent:
                    self._print_line(f"the sport service may be off; {_remedy('its mode')}")
                raise
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        problem: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        """After an exception, report that the sport service is off, or give the mode back."""
        if problem is None or not self._mode:
            return
        if self._give_back and not self._may_have_moved:
            self._select()
        else:
            self._print_off()

    def open_link(self, damping_kd: float) -> DdsLink:
        """Return the link to the robot.

        Args:
            damping_kd: kd in the damping commands that the link itself sends [N.m.s/rad].

        Raises:
            Error: Another program commands the robot, or the link cannot be opened.
        """
        tick = self._arguments.tick or "message"
        return DdsLink(self._network, self._arguments.sdk, damping_kd, tick=tick)

    def begin(self) -> None:
        """Note that the robot may move from now on."""
        self._may_have_moved = True

    def end(self, end: RunSnapshot) -> None:
        """Activate the mode of the sport service again, if this was requested and the robot lies.

        Args:
            end: Last snapshot of the run.
        """
        if not self._give_back:
            return
        if not self._mode:
            self._print_line("--give-back: no mode was active, none is given back")
        elif has_sat_down(end) or self._operator_confirms():
            self._select()
        else:
            self._print_line("--give-back: it is not certain that the robot lies")
            self._print_off()

    def _operator_confirms(self) -> bool:
        """Return whether the operator of a real robot types that it lies."""
        return (
            self._real
            and has_keyboard()
            and "lies"
            == _typed(
                "--give-back: it is not certain that the robot lies. Type lies + Enter when it "
                "lies; anything else leaves the sport service off: "
            )
        )

    def _select(self) -> None:
        assert self._switcher is not None  # not None, because it released a mode
        try:
            self._switcher.select_mode(self._mode)
        except Error as problem:
            self._print_line(f"--give-back: {problem}")
            self._print_off()
        else:
            self._print_line(f"motion switcher: mode '{self._mode}' is active again")
            self._mode = ""

    def _print_off(self) -> None:
        mode = f"mode '{self._mode}'"
        self._print_line(f"the sport service stays off ({mode} was active); {_remedy(mode)}")

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
        self._mode = switcher.release(self._note_release)
        self._print_line("motion switcher: no mode is active, the low level is free")

    def _note_release(self, line: str) -> None:
        self._release_sent = True
        self._print_line(line)

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


def has_sat_down(end: RunSnapshot) -> bool:
    """Return whether a run proves that its robot lies: it stood, then sat down as requested.

    The mode PASSIVE alone proves nothing: a robot that hangs or is silent has it as well.
    """
    return end.stood_to_end and end.mode == Mode.PASSIVE


def _remedy(mode: str) -> str:
    return (
        f"let the robot lie, then activate {mode} with the vendor's app or with "
        "surefoot.motion_switcher.MotionSwitcher.select_mode()"
    )


def _ask(question: str, answer: str) -> None:
    """Ask the operator; raise Error if the answer is another one or nobody can answer."""
    if not has_keyboard():
        raise Error(f"got no terminal for the answer, expected one: {question}")
    typed = _typed(question)
    if typed != answer:
        raise Error(f"got the answer '{typed}', expected '{answer}': the run does not begin")


def _typed(question: str) -> str:
    """Print a question; return the line that is typed after it, stripped, in lower case."""
    termios.tcflush(sys.stdin, termios.TCIFLUSH)  # what was typed before is no answer
    print(question, end="", flush=True, file=sys.stderr)
    return sys.stdin.readline().strip().lower()
