# SPDX-License-Identifier: BSD-3-Clause
"""benchmarks/weight_search.py: own gains give the scorecard outcome; bad gains score lower."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("optuna")
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

from push_objective import (
    LATENCY_20_MS,
    LEVEL_GROUND,
    MAX_PENALTY,
    PushedRobot,
    PushSet,
    default_values,
    score,
)
from surefoot import load_robot
from surefoot.assess import ControllerUnderTest
from surefoot.assess.push_limits import PushLimits
from surefoot.assess.push_outcome import judge_push
from surefoot.assess.work_units import PushUnit

pytestmark = pytest.mark.slow

BENCHMARKS = Path(__file__).resolve().parents[2] / "benchmarks"


@pytest.mark.parametrize("robot", ["go1", "b1"])
def test_robot_gains_give_the_scorecard_outcome(robot: str) -> None:
    limit = PushLimits(load_robot(robot)).push_limit(LEVEL_GROUND, 157.5, 0.1, 0.0).limit
    unit = PushUnit(LEVEL_GROUND, 157.5, 0.1, 0.0, 1, limit)
    expected = judge_push(
        unit.simulate(robot, ControllerUnderTest(), 80.0), LEVEL_GROUND.quiet_s, 0.1
    )
    outcome, upright = PushedRobot(robot, default_values(robot)).push(LEVEL_GROUND, 157.5, 1, 80.0)
    assert outcome == expected and outcome.survived and upright == 1.0


def test_delayed_condition_gives_the_scorecard_outcome() -> None:
    limit = PushLimits(load_robot("a1")).push_limit(LEVEL_GROUND, 90.0, 0.1, 0.0).limit
    unit = PushUnit(LATENCY_20_MS, 90.0, 0.1, 0.0, 0, limit)
    expected = judge_push(
        unit.simulate("a1", ControllerUnderTest(), 85.0), LATENCY_20_MS.quiet_s, 0.1
    )
    pushed = PushedRobot("a1", default_values("a1"))
    assert pushed.push(LATENCY_20_MS, 90.0, 0, 85.0)[0] == expected
    assert pushed.survived_levels(LATENCY_20_MS, 90.0, 0, [40.0, 85.0]) == 1.0 + expected.survived


def test_gains_that_let_feet_move_score_below_hopeless() -> None:
    slippery = {**default_values("b1"), "penalty_hold_down": 0.05, "weight_com_vertical": 0.05}
    objective, survived = score("b1", slippery, PushSet([100.0], [100.0], 95.0))
    assert objective < -MAX_PENALTY and survived == []


def test_invalid_levels_and_seeds_are_refused() -> None:
    for option, value, told in (
        ("--late", "0", "got 0, expected > 0 and <= 200 [% of the push limit]"),
        ("--levels", "nan", "got nan, expected > 0 and <= 200 [% of the push limit]"),
        ("--strict", "201", "got 201, expected > 0 and <= 200 [% of the push limit]"),
        ("--seeds", "0", "got 0, expected an integer >= 1"),
    ):
        command = [sys.executable, "weight_search.py", "--robot", "go1", option, value]
        said = subprocess.run(command, cwd=BENCHMARKS, capture_output=True, text=True)
        assert said.returncode == 2 and told in said.stderr


def test_search_evaluates_the_robot_gains_first() -> None:
    command = [sys.executable, "weight_search.py", "--robot", "go1", "--trials", "1"]
    command += ["--levels", "80", "40", "--late", "50"]
    said = subprocess.run(command, cwd=BENCHMARKS, capture_output=True, text=True, check=True)
    first, *rows = said.stdout.splitlines()
    assert first == "# trial 0: 33.0; levels survived by heading:" + 9 * " 3.0"
    told = dict(row.split(" = ") for row in rows)
    own = default_values("go1")
    assert {name: float(value) for name, value in told.items()} == pytest.approx(own, rel=1e-3)
