# SPDX-License-Identifier: BSD-3-Clause
"""Short form of benchmarks/external_lifts.py: a lift, a drop, and a failure it must detect."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

import external_lifts
from external_lifts import KINDS, TIME_BEFORE, random_lift, run, summarise, summary_line
from surefoot.sim import Lift

pytestmark = pytest.mark.slow

LOW = Lift("trunk", TIME_BEFORE, 1.0, 0.06, 0.4, 0.1, 0.2)


def low(_kind: str, _rng: np.random.Generator) -> Lift:
    return LOW


@pytest.mark.parametrize("robot", ["go1", "b1"])
def test_a_robot_lifted_by_6_cm_and_put_down_stands(monkeypatch, robot: str) -> None:
    monkeypatch.setattr(external_lifts, "random_lift", low)
    outcome = run((robot, "lift", 0))
    assert outcome.ok, outcome.why
    assert "lifted" in outcome.faults
    assert outcome.tilt_deg < 5.0


@pytest.mark.parametrize("robot", ["go1", "b1"])
def test_a_robot_dropped_from_10_cm_stands(robot: str) -> None:
    outcome = run((robot, "drop", 0))
    assert outcome.ok, outcome.why
    assert outcome.height == 0.1 and "lifted" in outcome.faults


def test_drop_from_1_m_is_reported_as_failure(monkeypatch) -> None:
    monkeypatch.setattr(
        external_lifts, "random_lift", lambda *_: Lift("trunk", TIME_BEFORE, 1.5, 1.0, 2.0)
    )
    outcome = run(("go1", "drop", 0))
    assert not outcome.ok and "after the lift began" in outcome.why
    summary = summarise([outcome])
    assert summary["stand"] == 0 and summary["failures"][0]["seed"] == 0
    assert summary_line(summary).startswith("go1 drop: 0 of 1 stand")


def test_external_lifts_vary_with_the_seed_within_their_ranges() -> None:
    for kind in KINDS:
        drawings = {random_lift(kind, np.random.default_rng(seed)) for seed in range(50)}
        assert len(drawings) == 50
        assert all(lift.desired_height(lift.time + 0.5 * lift.duration) > 0.0 for lift in drawings)
        heights = {lift.height for lift in drawings}
        assert heights == {0.1} if kind == "drop" else 0.05 < min(heights) < max(heights) < 0.3
