"""Lines typed on the keyboard, none of them late, and its end said."""

from __future__ import annotations

import os
import select
import sys
import termios
from collections.abc import Callable

from surefoot.system.terminal import has_keyboard

_MAX_EOFS = 3  # one after the other: the terminal is gone, and no Ctrl-D


class KeyboardLines:
    """Reads lines from the terminal without waiting, and without keeping any back.

    Args:
        print_line: Called with a line about the keyboard itself.
    """

    def __init__(self, print_line: Callable[[str], None]) -> None:
        self._print_line = print_line
        self._partial_line, self._eof_count = "", 0
        self.present = has_keyboard()

    def lines(self) -> list[str]:
        """Return what has been typed since the last look, without blanks at the ends."""
        typed = ""
        while self.present and select.select([sys.stdin], [], [], 0.0)[0]:
            got = os.read(sys.stdin.fileno(), 4096).decode(errors="replace")
            typed += got
            self._eof_count = 0 if got else self._eof_count + 1
            if self._eof_count == 1:
                self._print_line("Ctrl-D ends nothing: keys are still obeyed")
            if self._eof_count >= _MAX_EOFS:
                self.present = False
                self._print_line("the keyboard is gone: Ctrl-C and the remote's button B are left")
        *whole, self._partial_line = (self._partial_line + typed).split("\n")
        return [line.strip() for line in whole if line.strip()]

    def discard_typed(self) -> bool:
        """Leave out what has been typed and not been read; return whether there is a keyboard."""
        if self.present:
            termios.tcflush(sys.stdin, termios.TCIFLUSH)
            self._partial_line = ""
        return self.present
