"""Lines typed on the keyboard, none of them late, and its end said."""

from __future__ import annotations

import os
import select
import sys
import termios
from collections.abc import Callable

from surefoot.terminal import has_keyboard

_ENDS = 3  # one after the other: the terminal is gone, and no Ctrl-D


class Keys:
    """Reads lines from the terminal without waiting, and without keeping any back.

    Args:
        say: Called with a line about the keyboard itself.
    """

    def __init__(self, say: Callable[[str], None]) -> None:
        self._say = say
        self._rest, self._ends = "", 0
        self.present = has_keyboard()

    def lines(self) -> list[str]:
        """Return what has been typed since the last look, without blanks at the ends."""
        typed = ""
        while self.present and select.select([sys.stdin], [], [], 0.0)[0]:
            got = os.read(sys.stdin.fileno(), 4096).decode(errors="replace")
            typed += got
            self._ends = 0 if got else self._ends + 1
            if self._ends == 1:
                self._say("Ctrl-D ends nothing: keys are still obeyed")
            if self._ends >= _ENDS:
                self.present = False
                self._say("the keyboard is gone: Ctrl-C and the remote's button B are left")
        *whole, self._rest = (self._rest + typed).split("\n")
        return [line.strip() for line in whole if line.strip()]

    def forget(self) -> bool:
        """Leave out what has been typed and not been read; return whether there is a keyboard."""
        if self.present:
            termios.tcflush(sys.stdin, termios.TCIFLUSH)
            self._rest = ""
        return self.present
