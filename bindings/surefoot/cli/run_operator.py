"""The operator of surefoot run: keys to requests, and what keeps the robot from obeying them."""

from __future__ import annotations

from collections.abc import Callable

from surefoot._core import ArmingCheck, Mode, RequestStatus, Robot, RunSnapshot, StandRunner
from surefoot.cli.run_keys import Keys
from surefoot.low_state_layout import LEGS
from surefoot.terminal import has_keyboard

_REFUSALS = {
    RequestStatus.NO_STATE: "no valid LowState comes",
    RequestStatus.NOT_ARMED: "not armed: a + Enter arms",
    RequestStatus.LATCHED: "damping is latched: a + Enter arms again",
    RequestStatus.BUSY: "busy: torques are on their way; once more in a moment",
}
_FROM_HERE = {
    Mode.PASSIVE: "u rises",
    Mode.RISE: "d lies down",
    Mode.STAND: "d lies down",
    Mode.SIT: "u goes up again",
    Mode.DAMPING: "a arms",
}


def keys(rise: bool) -> str:
    """Return what can be typed; `rise`: to a robot that lies, else to one that stands."""
    if not has_keyboard():
        return "no terminal, no keys"
    arms = "a + Enter arms" if rise else "a + Enter takes it over again, as and where it is"
    return f"x + Enter damps, d lies down, {arms}, u goes up, q says joint angles"


class Operator:
    """Obeys lines typed on the keyboard.

    Args:
        runner: Is asked.
        robot: What it runs on, for names and limits.
        rise: As for keys().
        say: Called with a line about what was refused.
    """

    def __init__(
        self, runner: StandRunner, robot: Robot, rise: bool, say: Callable[[str], None]
    ) -> None:
        self._runner, self._robot, self._rise, self._say = runner, robot, rise, say
        self._keys = Keys(say)

    def look(self, now: RunSnapshot) -> None:
        """Obey what has been typed since the last look."""
        for line in self._keys.lines():
            self.obey(line.lower(), now)

    def forget(self) -> bool:
        """Leave out what has been typed and not been read; return whether there is a keyboard."""
        return self._keys.forget()

    def obey(self, word: str, now: RunSnapshot) -> None:
        """Do what a line asks for; say why not. Any line with an x in it damps."""
        up = Mode.STAND if now.mode == Mode.SIT else Mode.RISE
        if "x" in word or word == "stop":
            self._runner.damp()
        elif word in ("a", "arm", "r"):
            if now.armed:
                self._say(f"{now.time:7.2f} s armed already: {_FROM_HERE[now.mode]}")
            else:
                self._tell("arming", self._runner.arm(), now)
        elif word in ("u", "rise"):
            self._tell("up", self._runner.request(up), now)
        elif word in ("d", "sit"):
            self._tell("down", self._runner.request(Mode.SIT), now)
        elif word == "q":
            self._say(f"{now.time:7.2f} s joints [rad] {joints_text(now)}")
        else:
            self._say(f"{now.time:7.2f} s '{word}' is no key: {keys(self._rise)}")

    def _tell(self, what: str, status: RequestStatus, now: RunSnapshot) -> None:
        if status == RequestStatus.ACCEPTED:
            return
        why = _REFUSALS.get(status, "")
        if status == RequestStatus.NOT_READY:
            why = self._not_ready(now)
        if status == RequestStatus.OUT_OF_ORDER:
            why = f"not while {now.phase}: {_FROM_HERE[now.mode]}"
        self._say(f"{now.time:7.2f} s {what} refused: {why}")

    def _not_ready(self, now: RunSnapshot) -> str:
        failing = [name for name, check in now.arming.checks.items() if fails(check)]
        if failing:
            return f"arming checks fail: {', '.join(failing)}"
        return f"arming checks have passed for {now.arming.held:.1f} s, and must for 1"


def joints_text(now: RunSnapshot) -> str:
    """Return the joints' angles as reported, leg by leg: hip, thigh, calf."""
    legs = zip(LEGS, range(0, 12, 3), strict=True)
    return "; ".join(
        f"{leg} {' '.join(f'{angle:.3f}' for angle in now.joints[first : first + 3])}"
        for leg, first in legs
    )


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
        # A robot that is silent is braked before it is known whether it is to be let go of.
        if (now.phase, now.mode) not in (("passive", Mode.PASSIVE), ("damping", Mode.DAMPING)):
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
