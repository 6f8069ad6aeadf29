"""Keyboard of the terminal that operates the wireless remote."""

from __future__ import annotations

import os
import select
import sys
from typing import Any

from surefoot._core import Button
from surefoot.system.terminal import has_keyboard
from surefoot.virtual_robot.remote import AXES, Remote, RemoteEvent

KEYS_HELP = (
    "keys: w a s d: left stick, i j k l: right stick, space: centres both; A B X Y (capitals), "
    "arrows, Enter: START, Tab: SELECT, 1: L1, 2: L2, 9: R1, 0: R2, F: F1, G: F2 (capitals)"
)
# [s] Time after which a button is released, because a terminal does not report key releases.
# Chosen: longer than the delay of key repetition, and long enough for a controller to notice.
BUTTON_HOLD_TIME = 0.5
# Change of the position of an axis (-1 .. 1) per key press. Chosen: four presses move a stick to
# its end.
AXIS_STEP = 0.25
_AXIS_KEYS = {
    **{
        "a": ("lx", -AXIS_STEP),
        "d": ("lx", AXIS_STEP),
        "s": ("ly", -AXIS_STEP),
        "w": ("ly", AXIS_STEP),
    },
    **{
        "j": ("rx", -AXIS_STEP),
        "l": ("rx", AXIS_STEP),
        "k": ("ry", -AXIS_STEP),
        "i": ("ry", AXIS_STEP),
    },
}
_BUTTON_KEYS = {
    **{"A": Button.A, "B": Button.B, "X": Button.X, "Y": Button.Y, "F": Button.F1, "G": Button.F2},
    **{"1": Button.L1, "2": Button.L2, "9": Button.R1, "0": Button.R2},
    **{"\n": Button.START, "\r": Button.START, "\t": Button.SELECT},
    **{"\x1b[A": Button.UP, "\x1b[B": Button.DOWN, "\x1b[C": Button.RIGHT, "\x1b[D": Button.LEFT},
}


class Keyboard:
    """Context manager that reads keys without blocking, and restores the terminal at its end.

    Reads no keys if stdin is not a terminal, or if the process runs in the background.

    Args:
        remote: Remote that the keys operate.
    """

    def __init__(self, remote: Remote) -> None:
        self._remote = remote
        self._terminal_state: list[Any] | None = None
        self._pressed_since: dict[Button, float] = {}

    @property
    def is_available(self) -> bool:
        """True if keys can be read."""
        return self._terminal_state is not None

    def __enter__(self) -> Keyboard:
        if not has_keyboard():
            return self
        import termios
        import tty

        self._terminal_state = termios.tcgetattr(sys.stdin)
        tty.setcbreak(sys.stdin)
        return self

    def __exit__(self, *_: object) -> None:
        if self._terminal_state is not None:
            import termios

            termios.tcsetattr(sys.stdin, termios.TCSADRAIN, self._terminal_state)

    def poll(self, time: float) -> None:
        """Apply the keys pressed since the last poll, and release buttons after BUTTON_HOLD_TIME.

        Args:
            time: Present time [s].
        """
        if self.is_available and select.select([sys.stdin], [], [], 0.0)[0]:
            self.type_text(os.read(sys.stdin.fileno(), 64).decode(errors="ignore"), time)
        for button in [
            b for b, since in self._pressed_since.items() if time - since >= BUTTON_HOLD_TIME
        ]:
            del self._pressed_since[button]
            self._remote.apply(RemoteEvent(time, "release", button))

    def type_text(self, text: str, time: float) -> None:
        """Apply the keys of a text at a time [s]."""
        while text:
            key = text[:3] if text.startswith("\x1b[") else text[0]
            text = text[len(key) :]
            if key in _AXIS_KEYS:
                name, step = _AXIS_KEYS[key]
                value = max(-1.0, min(1.0, self._remote.stick(name) + step))
                self._remote.apply(RemoteEvent(time, name, value=value))
            elif key == " ":
                for name in AXES:
                    self._remote.apply(RemoteEvent(time, name, value=0.0))
            elif key in _BUTTON_KEYS:
                self._pressed_since[_BUTTON_KEYS[key]] = time
                self._remote.apply(RemoteEvent(time, "press", _BUTTON_KEYS[key]))
