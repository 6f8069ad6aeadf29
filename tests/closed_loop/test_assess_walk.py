# SPDX-License-Identifier: BSD-3-Clause
"""surefoot assess --walk: walks, pushes, scorecard, faulty controllers."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import surefoot
from surefoot import Error, cli
from surefoot.assess import (
    AssessSettings,
    Condition,
    ControllerUnderTest,
    WalkScorecard,
    read_walk_scorecard,
    standard_scorecard,
    standard_walk_scorecard,
)
from surefoot.assess.walking.walk_score import FIGURES
from surefoot.assess.walking.walk_units import WalkPushUnit, WalkUnit
from surefoot.assess.work_units import run_unit

pytestmark = pytest.mark.slow

LEVEL_GROUND = Condition("level ground")
LIP_LIMIT = 18.8  # [N.s] of a go1, forward


class Stands:
    """Controller that never walks."""

    def __init__(self, robot: surefoot.Robot) -> None:
        self.update = surefoot.StandController(robot).update

    def set_velocity(self, velocity: surefoot.WalkVelocity) -> None:
        """Ignore the velocity."""


class Refuses(Stands):
    """Controller that refuses every velocity but 0."""

    def set_velocity(self, velocity: surefoot.WalkVelocity) -> None:
        """Raise ValueError."""
        if velocity != surefoot.WalkVelocity():
            raise ValueError("too fast")


def walking(name: str) -> ControllerUnderTest:
    return ControllerUnderTest(name, walks=True)


def own(factory: Any) -> ControllerUnderTest:
    return ControllerUnderTest("own", factory=factory, walks=True)


@pytest.mark.parametrize("name", ControllerUnderTest(walks=True).built_in)
def test_built_in_controllers_follow_a_velocity_and_stop(name: str) -> None:
    unit = WalkUnit(LEVEL_GROUND, 0.0, (0.3, 0.0, 0.3), 2.5, 0)
    result = run_unit(unit, "go1", walking(name))
    assert not result["fell"] and result["steps"] > 10
    # The Raibert reference steps on while the base is faster than its source's 0.05 m/s, which
    # its own steps exceed on soft soles in some runs.
    assert result["stands_at_end"] or name == "raibert"
    assert np.all(np.array(result["velocity_mean_error"]) < [0.05, 0.05, 0.1])
    assert np.all(np.array(result["velocity_rmse"]) < [0.1, 0.1, 0.2])
    assert 0.0 <= result["saturated_percent"] < 5.0 and result["leg_contacts"] == 0
    assert set(FIGURES) <= set(result)


@pytest.mark.parametrize("name", ControllerUnderTest(walks=True).built_in)
@pytest.mark.parametrize("robot", ["a1", "b1"])
def test_references_walk_on_robots_of_all_sizes(robot: str, name: str) -> None:
    unit = WalkUnit(LEVEL_GROUND, 0.0, (0.3, 0.0, 0.0), 2.0, 0)
    result = run_unit(unit, robot, walking(name))
    assert not result["fell"] and result["velocity_mean_error"][0] < 0.05


def test_result_of_a_walk_is_repeatable_and_depends_on_the_condition() -> None:
    icy = Condition("icy", friction=0.3)
    units = [WalkUnit(c, 0.0, (0.3, 0.0, 0.0), 2.0, 3) for c in (LEVEL_GROUND, LEVEL_GROUND, icy)]
    first, again, other = (run_unit(unit, "go1", walking("surefoot")) for unit in units)
    assert first == again and other["velocity_rmse"] != first["velocity_rmse"]


def test_push_of_a_walking_robot_is_survived_up_to_a_level() -> None:
    unit = WalkPushUnit(LEVEL_GROUND, (0.3, 0.0, 0.0), 90.0, 0, 1, LIP_LIMIT, 50.0)
    result = run_unit(unit, "go1", walking("surefoot"))
    assert set(result) == {"percent_of_lip"} and 60.0 < result["percent_of_lip"] < 200.0


def test_robot_that_does_not_follow_its_command_survives_no_push() -> None:
    unit = WalkPushUnit(LEVEL_GROUND, (0.3, 0.0, 0.0), 0.0, 0, 0, LIP_LIMIT, 10.0)
    assert run_unit(unit, "go1", own(Stands)) == {"percent_of_lip": 0.0}


def test_failing_controllers_have_their_reason() -> None:
    unit = WalkUnit(LEVEL_GROUND, 0.0, (0.3, 0.0, 0.0), 2.0, 0)
    refused = run_unit(unit, "go1", own(Refuses))
    assert refused == {"broken": "set_velocity threw ValueError: too fast"}
    without = run_unit(unit, "go1", own(surefoot.StandController))
    assert "StandController without set_velocity()" in without["broken"]
    push = WalkPushUnit(LEVEL_GROUND, (0.3, 0.0, 0.0), 0.0, 0, 0, LIP_LIMIT, 10.0)
    assert run_unit(push, "go1", own(Refuses)) == {"percent_of_lip": 0.0, **refused}


def test_standard_scorecards_walk_at_velocities_within_the_limits_of_all_robots() -> None:
    for name in ("quick", "full"):
        card = standard_walk_scorecard(name)
        assert card.references and len(card.conditions) > 4
        for robot in surefoot.available_robots():
            controller = surefoot.WalkController(surefoot.load_robot(robot))
            for velocity in (*card.velocities, *card.push_velocities, card.condition_velocity):
                controller.set_velocity(surefoot.WalkVelocity(*velocity))
                assert controller.velocity_limit == surefoot.WalkLimit.NONE


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("velocitys = [[0.1, 0, 0]]", "unknown key 'velocitys'"),
        ("velocities = [[0.1, 0]]", "expected vx, vy, yaw rate"),
        ("velocities = []", "velocities: got none"),
        ("walk_s = 1.0", "walk_s"),
        ('[[condition]]\nname = "tilts"\ntilt_deg = 5.0', "tilt_deg: got 5.0, expected none"),
    ],
)
def test_invalid_walk_scorecard_is_refused(tmp_path: Path, text: str, words: str) -> None:
    path = tmp_path / "card.toml"
    path.write_text(text)
    with pytest.raises(Error) as caught:
        read_walk_scorecard(path)
    assert words in str(caught.value)


def test_card_and_controller_must_both_walk_or_both_stand() -> None:
    with pytest.raises(Error, match="expected a WalkScorecard"):
        AssessSettings("go1", ControllerUnderTest(walks=True), standard_scorecard("quick"))
    with pytest.raises(Error, match="expected a Scorecard"):
        AssessSettings("go1", ControllerUnderTest(), WalkScorecard("x"))


def test_walk_command_writes_json_and_report(tmp_path: Path, capsys: Any) -> None:
    card = tmp_path / "tiny.toml"
    card.write_text(
        "velocities = [[0.3, 0.0, 0.0]]\nwalk_s = 2.0\nseeds = 1\ncondition_seeds = 1\n"
        'references = true\n[[condition]]\nname = "level ground"\n'
        '[[condition]]\nname = "gentle slope"\nslope_deg = 5.0\n'
    )
    out, store = tmp_path / "out", tmp_path / "store"
    words = ["assess", "--walk", "--robot", "go1", "--scenario", str(card), "--jobs", "1"]
    words += ["--store", str(store), "--report", str(out)]
    assert cli.main(words) == 0
    text = capsys.readouterr().out
    assert "raibert: worst of the seeds" in text and "gentle slope" in text
    summary = json.loads((out / "summary.json").read_text())
    assert summary["walk"]["velocities"][0]["walked"] == 1
    assert summary["references"]["raibert"]["velocities"][0]["walked"] == 1
    assert summary["conditions"][0]["settings"] == {"slope_deg": 5.0}
    assert set(FIGURES) <= set(summary["conditions"][0])
    assert "gentle slope" in (out / "index.html").read_text()
    lines = store.read_text().count("\n")
    assert cli.main(words) == 0 and store.read_text().count("\n") == lines  # resumed: nothing ran
