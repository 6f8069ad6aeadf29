# SPDX-License-Identifier: BSD-3-Clause
"""Sixty mutated logs of benchmarks/mutate_logs.py, and that its judge finds wrong results."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

from mutate_logs import _judge, reference, run_case
from seed_runs import ROBOTS

pytestmark = pytest.mark.slow
COUNT = 60


@pytest.mark.parametrize("robot", ROBOTS)
def test_mutated_logs_are_refused_by_name_or_estimated(robot) -> None:
    first = ROBOTS.index(robot)
    cases = [run_case((robot, seed)) for seed in range(first, COUNT, len(ROBOTS))]
    assert [case.why for case in cases if not case.ok] == []
    assert {case.end for case in cases} == {"refused", "estimated", "same"}


def test_judge_finds_wrong_results() -> None:
    good = reference("go1", False)
    assert _judge(0, "", good, good) == ""
    assert "not" not in _judge(2, "surefoot: error: log.csv: line 4: got 'a'", None, None)
    assert "without a place" in _judge(2, "surefoot: error: something is wrong", None, None)
    assert "is refused" in _judge(2, "surefoot: error: log.csv: line 4: got 'a'", None, good)
    assert "velocity is" in _judge(0, "", {**good, "velocity": [None] * 3}, None)
    assert "differs" in _judge(0, "", {**good, "position": [1.0, 0.0, 0.3]}, good)
