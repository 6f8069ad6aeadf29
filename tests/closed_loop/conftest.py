# SPDX-License-Identifier: BSD-3-Clause
"""Cleanup after real-time tests: leftover processes must not disturb the next test."""

from __future__ import annotations

import contextlib
import os
import signal
from collections.abc import Iterator
from pathlib import Path

import pytest


def children() -> set[int]:
    """Return the ids of this process's child processes."""
    found = set()
    for folder in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):  # the process has just ended
            parent = (folder / "stat").read_text().rpartition(") ")[2].split()[1]
            if int(parent) == os.getpid():
                found.add(int(folder.name))
    return found


@pytest.fixture(autouse=True)
def kill_leftover_processes(request: pytest.FixtureRequest) -> Iterator[None]:
    """Kill the robot and controller processes that a real-time test left running."""
    if request.node.get_closest_marker("real_time") is None:
        yield
        return
    others = children()
    yield
    for process in children() - others:
        with contextlib.suppress(ProcessLookupError, ChildProcessError):
            os.kill(process, signal.SIGKILL)
            os.waitpid(process, 0)
