"""Operator of surefoot run: turns keys into requests and prints why a request is refused."""

from __future__ import annotations

from collections.abc import Callable

from surefoot._core import Error, Mode, RequestStatus, Robot, Runner, RunSnapshot, WalkLimit
from surefoot.cli.gait_argument import read_gait
from surefoot.cli.run_keyboard import KeyboardLines
from surefoot.cli.run_velocity import VELOCITY_HELP, KeyVelocity
from surefoot.messages.low_state_layout import LEGS
from surefoot.reports.refusal_reason import is_failing, refusal_reason
from surefoot.system.terminal import has_keyboard

_NEXT_KEY = {
    Mode.PASSIVE: "u rises",
    Mode.RISE: "wait until it stands, or d sits down",
    Mode.STAND: "w walks, d sits down",
    Mode.WALK: "s stops, d sits down",
    Mode.SIT: "u rises again",
    Mode.DAMPING: "a arms",
}


def key_help(rise: bool) -> str:
    """Return the keys and their meaning as text; `rise`: whether the robot starts lying."""
    if not has_keyboard():
        return "no terminal, no keys"
    arms = "a + Enter arms" if rise else "a + Enter takes the robot over again in its present pose"
    return (
        f"x + Enter damps, d sits down, {arms}, u rises, w walks, s stops, {VELOCITY_HELP}, "
        "gait auto|trot|walk chooses the gait, q prints joint angles"
    )


class Operator:
    """Handler of the lines typed on the keyboard.

    Args:
        runner: Receives the requests.
        robot: The robot that the runner controls, for names and limits.
        rise: Whether the robot starts lying.
        print_line: Called with the reason of each refusal.
    """

    def __init__(
        self, runner: Runner, robot: Robot, rise: bool, print_line: Callable[[str], None]
    ) -> None:
        self._runner, self._robot, self._rise, self._print_line = runner, robot, rise, print_line
        self._keys = KeyboardLines(print_line)
        self._velocity = KeyVelocity()
        self._start_presses = 0

    def update(self, snapshot: RunSnapshot) -> None:
        """Handle the lines typed since the last call, and send the velocity of a walking robot."""
        for line in self._keys.lines():
            self.handle_line(line.lower(), snapshot)
        if snapshot.mode == Mode.WALK:
            self._runner.set_velocity(self._velocity.velocity)
        else:
            self._velocity.reset()
        if snapshot.start_presses > self._start_presses:
            self._start_presses = snapshot.start_presses
            self._print_refusal("START", snapshot.start_answer, snapshot)

    def discard_typed(self) -> bool:
        """Discard typed lines that were not read; return False if there is no keyboard."""
        return self._keys.discard_typed()

    def handle_line(self, word: str, snapshot: RunSnapshot) -> None:
        """Send the request that a line stands for, or print why the request is refused.

        Every line that contains an x damps the robot.
        """
        up = Mode.STAND if snapshot.mode == Mode.SIT else Mode.RISE
        if "x" in word or word == "stop":
            self._runner.damp()
        elif word in ("a", "arm", "r"):
            if snapshot.armed:
                self._print_line(
                    f"{snapshot.time:7.2f} s armed already: {_NEXT_KEY[snapshot.mode]}"
                )
            else:
                self._print_refusal("arming", self._runner.arm(), snapshot)
        elif word in ("u", "rise"):
            self._print_refusal("up", self._runner.request(up), snapshot)
        elif word in ("d", "sit"):
            self._print_refusal("down", self._runner.request(Mode.SIT), snapshot)
        elif word in ("w", "walk"):
            self._print_refusal("walking", self._runner.request(Mode.WALK), snapshot)
        elif word in ("s", "stand"):
            self._print_refusal("standing", self._runner.request(Mode.STAND), snapshot)
        elif word == "q":
            self._print_line(f"{snapshot.time:7.2f} s joints [rad] {joints_text(snapshot)}")
        elif word.split()[0] == "gait":
            self._set_gait(" ".join(word.split()[1:]), snapshot)
        elif not self._change_velocity(word, snapshot):
            self._print_line(
                f"{snapshot.time:7.2f} s '{word}': unknown key: {key_help(self._rise)}"
            )

    def _set_gait(self, name: str, snapshot: RunSnapshot) -> None:
        """Set the gait of the mode WALK and print it, or print which gaits there are."""
        try:
            self._runner.set_gait(read_gait("gait", name))
        except Error as problem:
            self._print_line(f"{snapshot.time:7.2f} s {problem}")
            return
        self._print_line(f"{snapshot.time:7.2f} s gait {name}")

    def _change_velocity(self, line: str, snapshot: RunSnapshot) -> bool:
        """Change the velocity and print it; return whether the line is about the velocity."""
        if snapshot.mode == Mode.WALK and snapshot.velocity_limit != WalkLimit.NONE:
            self._velocity.reduce_to(snapshot.commanded_velocity)
        try:
            if not self._velocity.handle_line(line):
                return False
        except Error as problem:
            self._print_line(f"{snapshot.time:7.2f} s {problem}")
            return True
        walks = snapshot.mode == Mode.WALK
        text = f"velocity {self._velocity}" if walks else "velocity ignored: w walks first"
        self._print_line(f"{snapshot.time:7.2f} s {text}")
        return True

    def _print_refusal(self, what: str, status: RequestStatus, snapshot: RunSnapshot) -> None:
        if status == RequestStatus.ACCEPTED:
            return
        why = refusal_reason(status, snapshot)
        hint = {
            RequestStatus.NOT_ARMED: "a + Enter arms",
            RequestStatus.LATCHED: "a + Enter arms again",
            RequestStatus.OUT_OF_ORDER: _NEXT_KEY[snapshot.mode],
        }.get(status)
        why = why if hint is None else f"{why}: {hint}"
        self._print_line(f"{snapshot.time:7.2f} s {what} refused: {why}")


def joints_text(snapshot: RunSnapshot) -> str:
    """Return the measured joint angles [rad] of each leg (hip, thigh, calf) as text."""
    legs = zip(LEGS, range(0, 12, 3), strict=True)
    return "; ".join(
        f"{leg} {' '.join(f'{angle:.3f}' for angle in snapshot.joint_angles[first : first + 3])}"
        for leg, first in legs
    )


class ArmingMonitor:
    """Printer of the arming checks of a lying robot: prints failing checks, or that all pass.

    Args:
        robot: The robot that is armed, for names and limits.
        print_line: Called with a line for each failing check.
    """

    def __init__(self, robot: Robot, print_line: Callable[[str], None]) -> None:
        self._robot, self._print_line = robot, print_line
        self._failing, self._ready, self._armed = "", False, False

    def update(self, snapshot: RunSnapshot, due: bool) -> None:
        """Print checks whose result changed; `due`: print all failing checks again."""
        # While no LowState arrives, the phase is already DAMPING before the mode is. The arming
        # checks do not matter in that case.
        if (snapshot.phase, snapshot.mode) not in (
            ("passive", Mode.PASSIVE),
            ("damping", Mode.DAMPING),
        ):
            self._failing, self._ready = "", False
            return
        failing = " ".join(
            name for name, check in snapshot.arming.checks.items() if is_failing(check)
        )
        if failing and (due or failing != self._failing):
            for line in snapshot.arming.failures(self._robot).splitlines():
                self._print_line(f"{snapshot.time:7.2f} s not ready: {line}")
        if snapshot.arming.ready and not (self._ready and self._armed == snapshot.armed):
            self._print_line(f"{snapshot.time:7.2f} s ready{', armed' if snapshot.armed else ''}")
        self._failing, self._ready, self._armed = failing, snapshot.arming.ready, snapshot.armed
