"""The operator of surefoot run: keys to requests, and what keeps the robot from obeying them."""

from __future__ import annotations

import select
import sys
import termios
from collections.abc import Callable

from surefoot._core import ArmingCheck, Mode, RequestStatus, Robot, RunSnapshot, StandRunner
from surefoot.terminal import has_keyboard

KEYS = "a + Enter arms, u goes up, d lies down, x damps"
_REFUSALS = {
    RequestStatus.NO_STATE: "no valid LowState comes",
    RequestStatus.NOT_ARMED: "not armed: a + Enter arms",
    RequestStatus.NOT_READY: "arming checks fail, or have not passed for long enough",
    RequestStatus.LATCHED: "damping is latched: a + Enter arms again",
    RequestStatus.OUT_OF_ORDER: "not from here",
    RequestStatus.BUSY: "busy: torques are on their way; once more in a moment",
}


class Operator:
    """Obeys lines typed on the keyboard.

    Args:
        runner: Is asked.
        say: Called with a line about what was refused.
    """

    def __init__(self, runner: StandRunner, say: Callable[[str], None]) -> None:
        self._runner, self._say = runner, say
        self._present = has_keyboard()

    def look(self, now: RunSnapshot) -> None:
        """Obey what has been typed since the last look."""
        if self._present and select.select([sys.stdin], [], [], 0.0)[0]:
            line = sys.stdin.readline()
            self._present = bool(line)  # else its end
            if line.strip():
                self.obey(line.strip(), now)

    def forget(self) -> bool:
        """Leave out what has been typed and not been read; return whether there is a keyboard."""
        if self._present:
            termios.tcflush(sys.stdin, termios.TCIFLUSH)
        return self._present

    def obey(self, word: str, now: RunSnapshot) -> None:
        """Do what a line asks for; say why not."""
        up = Mode.STAND if now.mode == Mode.SIT else Mode.RISE
        if word in ("x", "stop"):
            self._runner.damp()
        elif word in ("a", "arm", "r"):
            self._tell("arming", self._runner.arm(), now)
        elif word in ("u", "rise"):
            self._tell("up", self._runner.request(up), now)
        elif word in ("d", "sit"):
            self._tell("down", self._runner.request(Mode.SIT), now)
        else:
            self._say(f"{now.time:7.2f} s '{word}' is no key: {KEYS}")

    def _tell(self, what: str, status: RequestStatus, now: RunSnapshot) -> None:
        if status != RequestStatus.ACCEPTED:
            self._say(f"{now.time:7.2f} s {what} refused: {_REFUSALS[status]}")


class UnaskedRise:
    """Arms and rises once, as soon as all checks pass, and ends a run that does not come to stand.

    Nothing is armed again after a latch.

    Args:
        runner: Is asked.
    """

    def __init__(self, runner: StandRunner) -> None:
        self._runner = runner
        self._asked = self._rising = False

    def look(self, now: RunSnapshot) -> None:
        """Ask for what is next."""
        self._rising |= now.mode == Mode.RISE
        if now.mode != Mode.PASSIVE:
            return
        if self._rising and not now.stood:
            self._runner.finish()
        elif not self._asked and now.arming.ready:
            self._ask(now)

    def _ask(self, now: RunSnapshot) -> None:
        if not now.armed:
            self._runner.arm()
        else:
            self._asked = self._runner.request(Mode.RISE) == RequestStatus.ACCEPTED


class Readiness:
    """Says what keeps a robot that is down from being armed, and when nothing does any more.

    Args:
        robot: Its names and limits.
        say: Called with a line for each failing check.
    """

    def __init__(self, robot: Robot, say: Callable[[str], None]) -> None:
        self._robot, self._say = robot, say
        self._failing, self._ready, self._armed = "", False, False

    def look(self, now: RunSnapshot, due: bool) -> None:
        """Say what has changed; `due`: say what fails once more."""
        if now.phase not in ("passive", "damping"):
            self._failing, self._ready = "", False
            return
        failing = " ".join(name for name, check in now.arming.checks.items() if fails(check))
        if failing and (due or failing != self._failing):
            for line in now.arming.failures(self._robot).splitlines():
                self._say(f"{now.time:7.2f} s not ready: {line}")
        if now.arming.ready and not (self._ready and self._armed == now.armed):
            self._say(f"{now.time:7.2f} s ready{', armed' if now.armed else ''}")
        self._failing, self._ready, self._armed = failing, now.arming.ready, now.armed


def fails(check: ArmingCheck) -> bool:
    """Return whether a check keeps the robot from being armed."""
    return bool(check.applies and not check.passed)
