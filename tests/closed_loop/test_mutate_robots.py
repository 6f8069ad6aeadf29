# SPDX-License-Identifier: BSD-3-Clause
"""Short form of benchmarks/mutate_robots.py, and failures that it must detect."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

import mutate_robots
from mutate_robots import run_mutant
from seed_runs import ROBOTS
from surefoot import Error

pytestmark = pytest.mark.slow


@pytest.mark.parametrize("robot", ROBOTS)
def test_mutated_robots_are_refused_by_name_or_stand(robot: str) -> None:
    mutants = [run_mutant((robot, seed)) for seed in range(ROBOTS.index(robot), 60, len(ROBOTS))]
    assert [mutant.why for mutant in mutants if not mutant.ok] == []
    assert {"refused", "stood"} <= {mutant.end for mutant in mutants}


def raise_error(*_: object) -> None:
    raise Error("something is wrong")


def raise_value_error(*_: object) -> None:
    raise ValueError("a traceback")


def hang(*_: object) -> None:
    while True:
        pass


@pytest.mark.parametrize(
    ("fail", "words"),
    [
        (raise_error, "no name in: something is wrong"),
        (raise_value_error, "ValueError: a traceback"),
        (hang, "the process ended with"),
    ],
)
def test_error_without_a_name_and_other_exceptions_fail(monkeypatch, fail, words: str) -> None:
    monkeypatch.setattr(mutate_robots, "build_robot", fail)
    monkeypatch.setattr(mutate_robots, "MAX_CPU_TIME", 1.0)
    mutant = run_mutant(("go1", 1))
    assert not mutant.ok
    assert words in mutant.why
