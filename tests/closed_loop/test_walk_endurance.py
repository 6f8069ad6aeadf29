# SPDX-License-Identifier: BSD-3-Clause
"""Short form of benchmarks/walk_endurance.py, and failures that it must detect."""

from __future__ import annotations

import sys
from collections import Counter
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

import random_walk
from walk_endurance import percentiles, run_episode, summary, text

pytestmark = pytest.mark.slow


def test_go1_walks_at_random_velocities_on_level_ground(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(random_walk, "GROUNDS", ("level",))
    episode = run_episode(("go1", 10, 3), duration=9.0)
    result = summary("go1", {3: episode})
    assert result["failures"] == {}, text(result)
    assert result["walking_ticks"] > 2000
    assert (result["not_first"], result["not_solved"]) == (0, 0)
    assert episode.tracked_ticks > 100


def test_push_beyond_the_limit_is_a_failure_with_its_seed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(random_walk, "PUSH_SHARE", (4.0, 5.0))
    result = summary("go1", {3: run_episode(("go1", 10, 3), duration=15.0)})
    assert list(result["failures"]) == [3]
    assert "DAMPING" in text(result) or "fell" in text(result)


def test_an_episode_repeats_exactly() -> None:
    first, second = (run_episode(("go1", 10, 5), duration=4.0) for _ in range(2))
    first.tick_us = second.tick_us = {}
    assert first == second


def test_percentiles_of_a_histogram() -> None:
    assert percentiles(Counter({10: 98, 20: 1, 30: 1})) == {
        "p50": 10, "p99": 20, "p99.9": 30, "max": 30,
    }  # fmt: skip
    assert set(percentiles(Counter()).values()) == {None}
