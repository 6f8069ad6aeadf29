# SPDX-License-Identifier: BSD-3-Clause
"""benchmarks/push_search.py: a robot's own values are its controller, others are told from it."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("optuna")
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

from push_worth import HOPELESS, LATE, LEVEL, Pushed, Pushes, own_values, score
from surefoot import load_robot
from surefoot.assess import Contestant
from surefoot.assess.push_limits import Limits
from surefoot.assess.push_run import judge
from surefoot.assess.unit import PushUnit

BENCHMARKS = Path(__file__).resolve().parents[2] / "benchmarks"


@pytest.mark.parametrize("robot", ["go1", "b1"])
def test_own_values_push_as_the_scorecard_does(robot: str) -> None:
    limit = Limits(load_robot(robot)).of(LEVEL, 157.5, 0.1, 0.0).own
    unit = PushUnit(LEVEL, 157.5, 0.1, 0.0, 1, limit)
    expected = judge(unit.play(robot, Contestant(), 80.0), LEVEL.quiet_s, 0.1)
    outcome, upright = Pushed(robot, own_values(robot)).push(LEVEL, 157.5, 1, 80.0)
    assert outcome == expected and outcome.survived and upright == 1.0


def test_late_pushes_are_predicted_over_as_the_scorecard_has_it() -> None:
    limit = Limits(load_robot("a1")).of(LEVEL, 90.0, 0.1, 0.0).own
    unit = PushUnit(LATE, 90.0, 0.1, 0.0, 0, limit)
    expected = judge(unit.play("a1", Contestant(), 85.0), LATE.quiet_s, 0.1)
    pushed = Pushed("a1", own_values("a1"))
    assert pushed.push(LATE, 90.0, 0, 85.0)[0] == expected
    assert pushed.survives(LATE, 90.0, 0, [40.0, 85.0]) == 1.0 + expected.survived


def test_a_set_that_lets_feet_move_is_worth_less_than_none() -> None:
    slippery = {**own_values("b1"), "penalty_hold_down": 0.05, "weight_com_vertical": 0.05}
    worth, survived = score("b1", slippery, Pushes([100.0], [100.0], 95.0))
    assert worth < -HOPELESS and survived == []


def test_levels_and_seeds_that_cannot_be_are_refused() -> None:
    for option, value, told in (
        ("--late", "0", "got 0, expected more than 0, 200 % at most"),
        ("--levels", "nan", "got nan, expected more than 0, 200 % at most"),
        ("--strict", "201", "got 201, expected more than 0, 200 % at most"),
        ("--seeds", "0", "got 0, expected a whole number from 1 up"),
    ):
        command = [sys.executable, "push_search.py", "--robot", "go1", option, value]
        said = subprocess.run(command, cwd=BENCHMARKS, capture_output=True, text=True)
        assert said.returncode == 2 and told in said.stderr


def test_the_search_says_the_robot_s_own_values_first() -> None:
    command = [sys.executable, "push_search.py", "--robot", "go1", "--trials", "1"]
    command += ["--levels", "80", "40", "--late", "50"]
    said = subprocess.run(command, cwd=BENCHMARKS, capture_output=True, text=True, check=True)
    first, *rows = said.stdout.splitlines()
    assert first == "# trial 0: 33.0; levels survived by heading:" + 9 * " 3.0"
    told = dict(row.split(" = ") for row in rows)
    own = own_values("go1")
    assert {name: float(value) for name, value in told.items()} == pytest.approx(own, rel=1e-3)
