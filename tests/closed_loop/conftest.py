# SPDX-License-Identifier: BSD-3-Clause
"""What a test that failed half way leaves behind must not disturb the next."""

from __future__ import annotations

import contextlib
import os
import signal
from collections.abc import Iterator
from pathlib import Path

import pytest


def children() -> set[int]:
    """Return the processes that this one has started."""
    found = set()
    for folder in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):  # it has just ended
            parent = (folder / "stat").read_text().rpartition(") ")[2].split()[1]
            if int(parent) == os.getpid():
                found.add(int(folder.name))
    return found


@pytest.fixture(autouse=True)
def kill_leftover_processes(request: pytest.FixtureRequest) -> Iterator[None]:
    """Kill the robots and controllers that a test which keeps real time did not come to end."""
    if request.node.get_closest_marker("real_time") is None:
        yield
        return
    others = children()
    yield
    for process in children() - others:
        with contextlib.suppress(ProcessLookupError, ChildProcessError):
            os.kill(process, signal.SIGKILL)
            os.waitpid(process, 0)
