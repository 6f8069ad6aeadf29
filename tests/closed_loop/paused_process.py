# SPDX-License-Identifier: BSD-3-Clause
"""Processes that a test stops for a while."""

from __future__ import annotations

import contextlib
import os
import signal
import struct
import subprocess
from collections.abc import Iterator
from pathlib import Path

_EXEMPT_OFFSET = 8  # [bytes] of exempt_process in the file of stall_tolerant_clock.cpp


@contextlib.contextmanager
def paused_process(process: subprocess.Popen[str]) -> Iterator[None]:
    """Stop a process; a stall-tolerant clock, if loaded, does not wait for it."""
    _exempt(process.pid)
    process.send_signal(signal.SIGSTOP)
    try:
        yield
    finally:
        process.send_signal(signal.SIGCONT)
        _exempt(0)


def _exempt(process: int) -> None:
    file = os.environ.get("STALL_TOLERANT_CLOCK")
    if file is not None:
        with Path(file).open("r+b") as clock:
            clock.seek(_EXEMPT_OFFSET)
            clock.write(struct.pack("q", process))
