"""The terminal that a command is run from: lines to it, keys from it, or neither."""

from __future__ import annotations

import os
import sys
from typing import TextIO


class LinePrinter:
    """Prints lines at once; a reader that goes away must not end what moves a robot."""

    def __init__(self, out: TextIO) -> None:
        self._out = out

    def __call__(self, line: str) -> None:
        """Print a line, or nothing if nobody reads any more."""
        try:
            print(line, file=self._out, flush=True)
        except OSError:  # the pipe is broken, or the terminal is closed
            os.dup2(os.open(os.devnull, os.O_WRONLY), self._out.fileno())


def has_keyboard() -> bool:
    """Return whether stdin is a terminal whose keys are for this process."""
    if sys.stdin is None or sys.stdin.closed or not sys.stdin.isatty():
        return False
    try:
        # A background process that reads its terminal is stopped by the system.
        return os.tcgetpgrp(sys.stdin.fileno()) == os.getpgrp()
    except OSError:  # a terminal, but not the one that controls this process
        return False
