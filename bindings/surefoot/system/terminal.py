"""Terminal of a command: printer of lines, and check whether a keyboard is available."""

from __future__ import annotations

import os
import sys
from typing import TextIO


class LinePrinter:
    """Printer of lines, flushed at once. A closed pipe or terminal does not end the process."""

    def __init__(self, out: TextIO) -> None:
        self._out = out

    def __call__(self, line: str) -> None:
        """Print a line; discard it if the pipe or terminal has closed."""
        try:
            print(line, file=self._out, flush=True)
        except OSError:  # the pipe is broken, or the terminal is closed
            os.dup2(os.open(os.devnull, os.O_WRONLY), self._out.fileno())


def has_keyboard() -> bool:
    """Return whether stdin is a terminal and this process runs in its foreground."""
    if sys.stdin is None or sys.stdin.closed or not sys.stdin.isatty():
        return False
    try:
        # The system stops a background process that reads from its terminal.
        return os.tcgetpgrp(sys.stdin.fileno()) == os.getpgrp()
    except OSError:  # stdin is not the controlling terminal of this process
        return False
