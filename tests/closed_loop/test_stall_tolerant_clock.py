# SPDX-License-Identifier: BSD-3-Clause
"""The stall-tolerant clock, on which the real-time tests run."""

from __future__ import annotations

import json
import os
import select
import signal
import time
from pathlib import Path

import pytest
from virtual_robot_helpers import start_controller, start_robot, wait_for

pytestmark = [
    pytest.mark.real_time,
    pytest.mark.skipif(
        "STALL_TOLERANT_CLOCK" not in os.environ, reason="make test preloads the clock"
    ),
]


def pause(seconds: float) -> None:
    """Wait on the system clock, which stalls do not stop."""
    select.select([], [], [], seconds)


def test_machine_stall_causes_no_damping(tmp_path: Path) -> None:
    robot, port = start_robot("--json", str(tmp_path / "robot.json"))
    run = start_controller(port, "--duration", "2", "--json", str(tmp_path / "run.json"))
    wait_for(run, "standing")
    for stopped in ([robot], [run], [robot, run]) * 2:
        for process in stopped:
            process.send_signal(signal.SIGSTOP)
        pause(0.06)
        for process in stopped:
            process.send_signal(signal.SIGCONT)
        pause(0.1)
    run.communicate(timeout=60)
    robot.send_signal(signal.SIGTERM)
    robot.wait(timeout=20)
    result = json.loads((tmp_path / "run.json").read_text())
    record = json.loads((tmp_path / "robot.json").read_text())
    assert (run.returncode, result["dampings"], result["rearms"]) == (0, 0, 0)
    assert record["slipped"] == 0.0


def test_clock_does_not_wait_for_a_dead_process(tmp_path: Path) -> None:
    robot, port = start_robot()
    run = start_controller(port)
    wait_for(run, "standing")
    robot.kill()
    began, real = time.monotonic(), time.clock_gettime(time.CLOCK_MONOTONIC_RAW)
    wait_for(run, "damping: stale")
    run.kill()
    run.wait(timeout=20)
    robot.wait(timeout=20)
    time.sleep(0.5)
    held = time.clock_gettime(time.CLOCK_MONOTONIC_RAW) - real - (time.monotonic() - began)
    assert 0.01 < held < 0.4
