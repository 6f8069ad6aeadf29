# SPDX-License-Identifier: BSD-3-Clause
"""Loops keep their periods on the system clock; the stall-tolerant clock would hide delays."""

from __future__ import annotations

import json
import os
import signal
import time
from pathlib import Path

import pytest
from virtual_robot_helpers import start_controller, start_robot

pytestmark = pytest.mark.real_time


@pytest.fixture
def with_system_clock(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("LD_PRELOAD", raising=False)


@pytest.mark.usefixtures("with_system_clock")
def test_median_tick_takes_less_than_half_its_period(tmp_path: Path) -> None:
    assert "LD_PRELOAD" not in os.environ
    robot, port = start_robot("--robot", "b1", "--json", str(tmp_path / "robot.json"))
    began = time.clock_gettime(time.CLOCK_MONOTONIC_RAW)
    words = ("--robot", "b1", "--duration", "3", "--json", str(tmp_path / "run.json"))
    run = start_controller(port, *words)
    run.communicate(timeout=60)
    took = time.clock_gettime(time.CLOCK_MONOTONIC_RAW) - began
    robot.send_signal(signal.SIGTERM)
    robot.wait(timeout=20)
    result = json.loads((tmp_path / "run.json").read_text())
    record = json.loads((tmp_path / "robot.json").read_text())
    # Medians: short stalls of the machine do not change them.
    assert result["us"]["tick_p50"] < 1000.0  # of a period of 2000
    assert took > 3.0
    assert record["real_time_factor"] > 0.5
