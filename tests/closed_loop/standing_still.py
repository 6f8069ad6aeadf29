# SPDX-License-Identifier: BSD-3-Clause
"""Programs that are stopped for a while, on purpose."""

from __future__ import annotations

import contextlib
import os
import signal
import struct
import subprocess
from collections.abc import Iterator
from pathlib import Path

_EXCUSED = 8  # [bytes] into the patient clock's file: patient_clock.cpp


@contextlib.contextmanager
def standing_still(process: subprocess.Popen[str]) -> Iterator[None]:
    """Stop a process for a while; the patient clock, where there is one, does not wait for it."""
    _excuse(process.pid)
    process.send_signal(signal.SIGSTOP)
    try:
        yield
    finally:
        process.send_signal(signal.SIGCONT)
        _excuse(0)


def _excuse(process: int) -> None:
    file = os.environ.get("PATIENT_CLOCK")
    if file is not None:
        with Path(file).open("r+b") as clock:
            clock.seek(_EXCUSED)
            clock.write(struct.pack("q", process))
