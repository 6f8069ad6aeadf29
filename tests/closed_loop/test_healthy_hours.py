# SPDX-License-Identifier: BSD-3-Clause
"""The short form of benchmarks/healthy_hours.py, and that it sees a trip."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

import healthy_hours
from healthy_hours import healthy, summary, text


@pytest.mark.parametrize("robot", ["go1", "b1"])
def test_a_healthy_robot_gets_up_stands_and_lies_down_without_a_trip(robot: str) -> None:
    run = healthy((robot, 1), standing=8.0)
    assert run.ok, run.why
    assert run.seconds > 12.0


def test_a_push_beyond_all_limits_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(healthy_hours, "SHARE", (3.0, 4.0))
    run = healthy(("go1", 1), standing=8.0)
    assert "damping for" in run.why or "fell" in run.why
    result = summary("go1", [run])
    assert list(result["trips"]) == [1]
    assert "1 false trips, 0 did not end" in text(result)


def test_a_run_that_does_not_end_is_no_trip_but_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(healthy_hours, "PATIENCE", 0.0)
    run = healthy(("go1", 1), standing=0.5)  # [s] too short to get up
    result = summary("go1", [run])
    assert not result["trips"] and list(result["unfinished"]) == [1]
    assert "0 false trips, 1 did not end" in text(result)
