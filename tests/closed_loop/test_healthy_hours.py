# SPDX-License-Identifier: BSD-3-Clause
"""The short form of benchmarks/healthy_hours.py, and that it sees a trip."""

from __future__ import annotations

import itertools
import sys
from pathlib import Path

import pytest
import surefoot

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

import healthy_hours
from healthy_hours import healthy, summary, text
from surefoot import Mode


@pytest.mark.parametrize("robot", ["go1", "b1"])
def test_a_healthy_robot_gets_up_stands_and_lies_down_without_a_trip(robot: str) -> None:
    run = healthy((robot, 1), standing=8.0)
    assert run.ok, run.why
    assert run.seconds > 12.0


def test_a_fault_before_the_body_leaves_the_ground_is_a_trip(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    # The supervisor lies down from there at once, and the next rise may go well.
    update, ticks = surefoot.Supervisor.update, itertools.count()

    def hot(supervisor: surefoot.Supervisor, state: surefoot.LowState) -> surefoot.LowCmd:
        if supervisor.mode == Mode.RISE and next(ticks) < 1000:
            state.bms.SOC = 1
        return update(supervisor, state)

    monkeypatch.setattr(surefoot.Supervisor, "update", hot)
    run = healthy(("go1", 1), standing=1.0)
    assert run.ended and "after battery" in run.why


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
