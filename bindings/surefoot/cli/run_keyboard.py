"""Lines typed on the keyboard, read without blocking."""

from __future__ import annotations

import os
import select
import sys
import termios
from collections.abc import Callable

from surefoot.system.terminal import has_keyboard

# Number of EOFs in a row after which the terminal counts as closed. Ctrl-D gives one EOF. Chosen: a
# person does not type three Ctrl-D in a row.
_MAX_EOFS = 3


class KeyboardLines:
    """Reader of lines from the terminal that does not block.

    It reads the file descriptor directly, because the buffer of sys.stdin would delay lines.

    Args:
        print_line: Called with messages about the keyboard itself.
    """

    def __init__(self, print_line: Callable[[str], None]) -> None:
        self._print_line = print_line
        self._partial_line, self._eof_count = "", 0
        self.present = has_keyboard()

    def lines(self) -> list[str]:
        """Return the complete lines typed since the last call, stripped, without empty lines."""
        typed = ""
        while self.present and select.select([sys.stdin], [], [], 0.0)[0]:
            got = os.read(sys.stdin.fileno(), 4096).decode(errors="replace")
            typed += got
            self._eof_count = 0 if got else self._eof_count + 1
            if self._eof_count == 1:
                self._print_line("Ctrl-D does not end the run: keys still work")
            if self._eof_count >= _MAX_EOFS:
                self.present = False
                self._print_line(
                    "the terminal has closed: stop with Ctrl-C or button B of the remote"
                )
        *whole, self._partial_line = (self._partial_line + typed).split("\n")
        return [line.strip() for line in whole if line.strip()]

    def discard_typed(self) -> bool:
        """Discard typed lines that were not read; return whether there is a keyboard."""
        if self.present:
            termios.tcflush(sys.stdin, termios.TCIFLUSH)
            self._partial_line = ""
        return self.present
