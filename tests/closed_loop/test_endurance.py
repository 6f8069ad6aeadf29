# SPDX-License-Identifier: BSD-3-Clause
"""Short form of benchmarks/endurance.py: a few seconds across the wrap of LowState.tick."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

import endurance
from endurance import LIMITS, DriftMonitor, Pose, run_endurance
from surefoot.sim import Plant, PlantSettings, Push

pytestmark = pytest.mark.slow


@pytest.mark.parametrize("robot", ["go1", "b1"])
def test_quiet_standing_continues_across_the_tick_wrap(monkeypatch, robot: str) -> None:
    monkeypatch.setattr(endurance, "SETTLE_TIME", 2.0)
    result = run_endurance(robot, 6.0, seed=1)
    assert result["failures"] == []
    assert result["wraps"] == 1
    assert result["hours"] == pytest.approx(6.0 / 3600.0)
    for name, limit in LIMITS.items():
        if name != "memory_mb":  # other tests change it
            share = 1.0 if name == "believed_tilt_deg" else 0.2  # includes the sensors' biases
            assert 0.0 < result["worst"][name] < share * limit, name


@pytest.mark.parametrize(
    ("share", "said"),
    [(0.5, ("tilt_deg", "com_mm")), (4.0, ("DAMPING", "fault power 1 times", "ticks failed"))],
)
def test_endurance_failures_are_reported(monkeypatch, share: float, said: tuple[str, ...]) -> None:
    class Pushed(Plant):
        def __init__(self, robot: str, settings: PlantSettings, tick0: int) -> None:
            super().__init__(robot, settings, tick0=0)
            self.add_push(Push("lateral", share * self.lip_push_limit("lateral"), time=3.0))

    monkeypatch.setattr(endurance, "SETTLE_TIME", 2.0)
    monkeypatch.setattr(endurance, "Plant", Pushed)
    failures = "; ".join(run_endurance("go1", 6.0)["failures"])
    assert [part for part in (*said, "wrapped 0 times") if part not in failures] == []


def test_nan_drift_fails_its_limit() -> None:
    monitor = DriftMonitor()
    for value in (0.5, float("nan"), 0.2):
        monitor.record_drift({"height_mm": value})
    assert not monitor.worst["height_mm"] <= LIMITS["height_mm"]


def test_drift_is_measured_in_the_units_of_the_limits() -> None:
    feet, com, c, s = np.zeros((3, 4)), np.zeros(3), np.cos(0.1), np.sin(0.1)
    start = Pose(feet, 0.3, np.eye(3), com)
    yawed = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    pitched = np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
    step, shift = np.array([[0.003], [0.0], [0.004]]), np.array([0.0, 0.002, 0.0])
    moved = Pose(feet + step, 0.301, yawed, com + shift)
    drift = moved.drift(start)
    expected = {"height_mm": 1.0, "yaw_deg": np.degrees(0.1), "foot_travel_mm": 5.0, "com_mm": 2.0}
    assert {name: drift[name] for name in expected} == pytest.approx(expected)
    assert drift["tilt_deg"] == pytest.approx(0.0, abs=1e-6)
    tilted = Pose(feet, 0.3, pitched, com).drift(start)
    assert tilted["tilt_deg"] == pytest.approx(np.degrees(0.1))
    assert tilted["yaw_deg"] == pytest.approx(0.0, abs=1e-6)
