# SPDX-License-Identifier: BSD-3-Clause
"""Short form of benchmarks/false_trips.py, and trips that it must detect."""

from __future__ import annotations

import itertools
import sys
from pathlib import Path

import pytest
import surefoot

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

import false_trips
from false_trips import run_healthy, summary, text
from surefoot import Mode

pytestmark = pytest.mark.slow


@pytest.mark.parametrize("robot", ["go1", "b1"])
def test_healthy_robot_completes_a_cycle_without_a_false_trip(robot: str) -> None:
    run = run_healthy((robot, 1), standing=8.0)
    assert run.ok, run.why
    assert run.seconds > 12.0


def test_fault_before_liftoff_counts_as_a_trip(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    # The supervisor lowers the robot at once, and the next rise may succeed.
    update, ticks = surefoot.Supervisor.update, itertools.count()

    def low_battery_update(
        supervisor: surefoot.Supervisor, state: surefoot.LowState
    ) -> surefoot.LowCmd:
        if supervisor.mode == Mode.RISE and next(ticks) < 1000:
            state.bms.SOC = 1
        return update(supervisor, state)

    monkeypatch.setattr(surefoot.Supervisor, "update", low_battery_update)
    run = run_healthy(("go1", 1), standing=1.0)
    assert run.ended and "after battery" in run.why


def test_push_beyond_the_limits_counts_as_a_trip(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(false_trips, "PUSH_SHARE", (3.0, 4.0))
    run = run_healthy(("go1", 1), standing=8.0)
    assert "damping for" in run.why or "fell" in run.why
    result = summary("go1", [run])
    assert list(result["trips"]) == [1]
    assert "1 false trips, 0 did not end" in text(result)


def test_unfinished_run_is_reported_separately_from_trips(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(false_trips, "MAX_TRANSITION_TIME", 0.0)
    run = run_healthy(("go1", 1), standing=0.5)  # [s]; too short to get up
    result = summary("go1", [run])
    assert not result["trips"] and list(result["unfinished"]) == [1]
    assert "0 false trips, 1 did not end" in text(result)
