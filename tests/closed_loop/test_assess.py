# SPDX-License-Identifier: BSD-3-Clause
"""surefoot assess: sweep, scorecard, result store, working and faulty controllers."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from itertools import pairwise
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
    Scorecard,
    read_scorecard,
    run_assess,
)
from surefoot.assess.condition_plant import plant_of
from surefoot.assess.push_limits import PushLimits
from surefoot.assess.push_outcome import PushOutcome, judge_push
from surefoot.assess.rollout import roll_out
from surefoot.assess.scorecard import standard_scorecard
from surefoot.assess.sweep import first_level, outcome_rows, rows_to_sweep, run_sweep
from surefoot.assess.work_units import PushUnit, StandUnit, run_unit

pytestmark = pytest.mark.slow

LEVEL_GROUND = Condition("level ground")
FEW = Scorecard(
    "few", directions=1, seeds=1, condition_directions=1, condition_seeds=1, faults="none"
)


def push_unit(direction_deg: float = 90.0) -> PushUnit:
    limit = (
        PushLimits(surefoot.load_robot("go1"))
        .push_limit(LEVEL_GROUND, direction_deg, 0.1, 0.0)
        .limit
    )
    return PushUnit(LEVEL_GROUND, direction_deg, 0.1, 0.0, 0, limit)


def controller_under_test(name: str) -> ControllerUnderTest:
    return ControllerUnderTest(f"assess_controllers:{name}")


# The sweep.


@pytest.mark.parametrize("first", [10.0, 20.0, 60.0])
@pytest.mark.parametrize("survives", [*np.arange(0.0, 202.5, 2.5)])
def test_sweep_finds_the_highest_level_below_the_first_failure(
    first: float, survives: float
) -> None:
    strict = min(47.0, 0.8 * survives)
    done = run_sweep(
        lambda level: PushOutcome(level <= survives, level <= strict, 0.0, 0.0, 0.0), first
    )
    assert done.largest_passed("survived") == survives
    assert strict - 2.5 < done.largest_passed("in_place") <= strict
    assert set(np.arange(first, min(survives + 20.0, 200.0), 20.0)) <= set(done.outcomes)
    # A sweep that starts above the largest passed level continues upward from 0 %.
    missed = ((survives < first) + (strict < first)) * first / 5.0
    assert len(done.outcomes) <= max(0.0, survives - first) / 20.0 + 10 + missed


def test_sweep_uses_the_requested_resolution() -> None:
    done = run_sweep(
        lambda level: PushOutcome(level < 109.0, level < 71.0, 0.0, 0.0, 0.0), finest_step=5.0
    )
    assert (done.largest_passed("survived"), done.largest_passed("in_place")) == (105.0, 70.0)
    assert all(level % 5.0 == 0.0 for level in done.outcomes)
    with pytest.raises(Error, match=r"finest: got 3 %, expected 5 or 2\.5"):
        run_sweep(lambda level: PushOutcome(True, True, 0.0, 0.0, 0.0), finest_step=3.0)


def test_seeds_start_at_different_coarse_levels() -> None:
    passes, tried = PushOutcome(True, True, 0.0, 0.0, 0.0), set[float]()
    assert [first_level(turn) for turn in range(7)] == [10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 10.0]
    for turn in range(6):
        tried |= set(run_sweep(lambda level: passes, first_level(turn)).outcomes)
    assert tried == set(np.arange(10.0, 210.0, 10.0))


def test_sweep_result_ends_below_the_weakest_failed_push() -> None:
    done = run_sweep(
        lambda level: PushOutcome(level < 120.0, not 38.0 < level < 42.0, 0.0, 0.0, 0.0), 20.0
    )
    assert done.outcomes[100.0].in_place
    assert done.largest_passed("in_place") == 37.5


def test_sweep_of_a_robot_that_always_falls_is_zero() -> None:
    done = run_sweep(lambda level: PushOutcome(False, False, 0.0, None, None))
    assert done.largest_passed("survived") == done.largest_passed("in_place") == 0.0
    assert (
        rows_to_sweep(json.loads(json.dumps(outcome_rows(done)))).largest_passed("survived") == 0.0
    )


# The scorecard.


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("directons = 4", "unknown key 'directons' (did you mean 'directions'?)"),
        ("[[condition]]\nname = 'x'\nfrction = 0.4", "unknown key 'frction'"),
        ("[[condition]]\nfriction = 0.4", "got none of the key 'name'"),
        ("[[condition]]\nname = 'x'\nfriction = 'ice'", "condition 'x': friction: got 'ice'"),
        ("[[condition]]\nname = 'x'\nstep_foot = 'XX'", "valid names"),
        ("[[condition]]\nname = 'x'\nslope_deg = 5.0\npushes = true", "limits are of level ground"),
        ("[[condition]]\nname = 'x'\nslope_deg = 5.0", "expected level ground of the first"),
        ("[[condition]]\nname = 'x'\n[[condition]]\nname = 'x'", "each once"),
        ("seeds = 0", "seeds: got 0"),
        ("seeds = true", "seeds: got True"),
        ("lengths_s = []", "lengths_s: got ()"),
        ("lengths_s = 0.1", "lengths_s: got 0.1"),
        ("lengths_s = [0.1, 0.1000001]", "lengths_s: got 0.1, 0.1, expected each once"),
        ("[[condition]]\nname = 'x'\nheadings_deg = [0.0, 360.0]", "expected each once"),
        ("[[condition]]\nname = 'x'\nfriction = 1" + 400 * "0", "expected a number from 0.01"),
        (
            "condition_directions = 0\n[[condition]]\nname = 'x'\n"
            "[[condition]]\nname = 'y'\npushes = true",
            "condition 'y': pushes: got true, expected false where condition_directions",
        ),
        ("faults = 'some'", "expected none, brief or all"),
        ("seeds = ", "not valid TOML"),
    ],
)
def test_invalid_scorecard_file_is_refused(tmp_path: Path, text: str, words: str) -> None:
    file = tmp_path / "card.toml"
    file.write_text(text)
    with pytest.raises(Error) as caught:
        read_scorecard(file)
    assert words in str(caught.value) and "card.toml" in str(caught.value)


def test_standard_scorecards_match_the_protocol() -> None:
    full, quick = standard_scorecard("full"), standard_scorecard("quick")
    assert full.directions == quick.directions == 16 and full.seeds == 20 and quick.seeds == 3
    assert full.lengths_s == (0.02, 0.1, 0.5) and set(full.heights_m) == {0.0, 0.1, -0.1}
    assert quick.lengths_s == (0.1,) and quick.heights_m == (0.0,)
    assert {c.friction for c in full.conditions} >= {0.2, 0.4, 0.6, 0.8, 1.0}
    assert [c.name for c in quick.conditions] == [c.name for c in full.conditions]
    assert not any(c.pushes for c in quick.conditions)


# Controllers under test.


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("throws", "threw ValueError: no idea"),
        ("exits", "threw SystemExit: 3"),
        ("raises_cancelled", "threw CancelledError"),
        ("returns_nan", "returned tau = nan for motor 3"),
        ("returns_infinity", "returned Kd = inf for motor 11"),
        ("returns_wrong_shape", "returned ndarray of shape (11,), expected a LowCmd"),
        ("returns_none", "returned NoneType, expected a LowCmd"),
        ("factory_returns_int", "the factory returned int"),
        ("factory_returns_dict", "the factory returned dict"),
        ("factory_raises", "the factory threw RuntimeError: cannot be made"),
    ],
)
def test_invalid_controller_is_recorded_as_broken_with_the_reason(name: str, words: str) -> None:
    found = run_unit(push_unit(), "go1", controller_under_test(name))
    assert words in found["broken"]
    assert not any(survived for _, survived, *_ in found["rows"])


def test_controller_that_fails_at_strong_pushes_keeps_its_weaker_results() -> None:
    found = run_unit(push_unit(), "go1", controller_under_test("fails_above_1_rad_s"))
    assert found["broken"] == "threw RuntimeError: too far"
    done = rows_to_sweep(json.loads(json.dumps(found["rows"])))
    assert 10.0 <= done.largest_passed("survived") <= 100.0
    assert all(o.survived == (o.foot_mm is not None) for o in done.outcomes.values())


def test_robot_that_falls_before_the_push_survives_zero_percent() -> None:
    rows = run_unit(push_unit(), "go1", controller_under_test("zero_command"))["rows"]
    assert rows_to_sweep(rows).largest_passed("survived") == 0.0


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("nobody", "expected surefoot, pd, force_qp or module:callable"),
        ("assess_controllers:missing", "has no attribute 'missing'"),
        ("assess_controllers:not_a_factory", "got int, expected a callable"),
        ("no_such_module:x", "ModuleNotFoundError"),
    ],
)
def test_missing_controller_is_refused_before_the_run(name: str, words: str) -> None:
    with pytest.raises(Error) as caught:
        AssessSettings("go1", ControllerUnderTest(name))
    assert words in str(caught.value)


def test_module_import_beyond_the_deadline_is_refused() -> None:
    with pytest.raises(Error, match=r"its import took longer than 0\.2 s"):
        AssessSettings("go1", ControllerUnderTest("assess_slow_import:make"), deadline=0.2)


@pytest.mark.parametrize(
    ("what", "words"),
    [
        ({"factory": surefoot.StandController}, "got a factory called 'surefoot'"),
        (
            {"name": "pd", "gains": {"edge_tilt": 0.1}},
            "'pd': got gains, expected none: only surefoot",
        ),
        ({"gains": {"edge_tlit": 0.1}}, "unknown gain: got 'edge_tlit'"),
        ({"name": None}, "controller: got None"),
    ],
)
def test_ambiguous_controller_under_test_is_refused(what: dict[str, Any], words: str) -> None:
    with pytest.raises(Error, match=words):
        ControllerUnderTest(**what)


@pytest.mark.parametrize(
    ("what", "words"),
    [
        ({"jobs": 1.5}, r"jobs: got 1\.5, expected a whole number 1 \.\. 256"),
        ({"jobs": "2"}, "jobs: got '2'"),
        ({"deadline": "2"}, "deadline: got '2', expected a number"),
        ({"card": "quick"}, "card: got 'quick', expected a Scorecard"),
        (
            {"controller_under_test": "pd"},
            "controller_under_test: got 'pd', expected a ControllerUnderTest",
        ),
    ],
)
def test_invalid_settings_are_refused(what: dict[str, Any], words: str) -> None:
    with pytest.raises(Error, match=words):
        AssessSettings("go1", **what)


def test_factory_that_cannot_be_pickled_is_refused() -> None:
    with pytest.raises(Error, match="cannot be handed to another process"):
        AssessSettings("go1", ControllerUnderTest("mine", factory=lambda robot: None))


def test_callable_controller_gets_the_same_run_as_the_built_in() -> None:
    unit = push_unit()
    built_in = unit.simulate("go1", ControllerUnderTest("surefoot"), 60.0)
    for other in (
        controller_under_test("stand_controller"),
        ControllerUnderTest("mine", factory=surefoot.StandController),
    ):
        assert (unit.simulate("go1", other, 60.0).base == built_in.base).all()
    assert judge_push(built_in, LEVEL_GROUND.quiet_s, 0.1).in_place


@pytest.mark.parametrize("name", ControllerUnderTest().built_in)
@pytest.mark.parametrize("robot", ["go1", "b1"])
def test_built_in_controllers_stand_and_survive_a_60_percent_push(robot: str, name: str) -> None:
    stood = run_unit(StandUnit(LEVEL_GROUND, 0.0, 1), robot, ControllerUnderTest(name))
    assert stood["passed"] and stood["foot_mm"] < 2.0
    limit = PushLimits(surefoot.load_robot(robot)).push_limit(LEVEL_GROUND, 90.0, 0.1, 0.0).limit
    unit = PushUnit(LEVEL_GROUND, 90.0, 0.1, 0.0, 1, limit)
    assert judge_push(
        unit.simulate(robot, ControllerUnderTest(name), 60.0), LEVEL_GROUND.quiet_s, 0.1
    ).survived


# The run.


def test_lost_samples_repeat_and_lost_commands_keep_the_last_command() -> None:
    condition = Condition("lossy", loss_percent=30.0)
    plant = plant_of("go1", condition)
    plant.reseed(4)
    ticks: list[int] = []
    controller = surefoot.StandController(plant.robot)

    def act(state: surefoot.LowState) -> surefoot.LowCmd:
        ticks.append(state.tick)
        return controller.update(state)

    trajectory = roll_out(plant, condition, act, 0.6)
    steps = [b - a for a, b in pairwise(ticks)]
    assert trajectory.fall_tick is None and len(trajectory.base) == 301
    assert steps.count(0) == pytest.approx(0.3 * 300, rel=0.35) and min(steps) == 0
    assert ticks[0] == 0 and ticks[-1] <= 2 * 299


def test_run_is_repeatable_on_the_same_plant() -> None:
    unit = push_unit(0.0)
    first = unit.simulate("go1", ControllerUnderTest(), 50.0)
    push_unit(180.0).simulate("go1", ControllerUnderTest(), 80.0)
    again = unit.simulate("go1", ControllerUnderTest(), 50.0)
    assert (first.base == again.base).all() and (first.feet == again.feet).all()


# The store.


def test_killed_assessment_resumes_from_its_store(tmp_path: Path) -> None:
    card = tmp_path / "card.toml"
    card.write_text("directions = 2\nseeds = 1\ncondition_seeds = 0\nfaults = 'none'\n")
    store, place = tmp_path / "store", tmp_path / "out.json"
    words = [sys.executable, "-m", "surefoot.cli", "assess", "--controller", "pd", "--jobs", "1"]
    words += ["--scenario", str(card), "--store", str(store), "--json", str(place)]
    process = subprocess.Popen(words, start_new_session=True)
    try:
        while process.poll() is None and lines(store) < 2:
            time.sleep(0.02)
    finally:
        os.kill(process.pid, signal.SIGKILL)
        process.wait()
    kept = store.read_bytes()
    assert not place.exists() and 2 <= lines(store) < 3
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL, timeout=300)
    assert store.read_bytes().startswith(kept[: kept.rindex(b"\n")]) and lines(store) == 3
    alone = run_assess(AssessSettings("go1", ControllerUnderTest("pd"), read_scorecard(card)))
    resumed = json.loads(place.read_text())
    assert resumed["push"] == alone["push"]


def test_sweep_with_a_broken_controller_is_complete_and_filmed(tmp_path: Path) -> None:
    card = Scorecard("few", directions=1, seeds=1, condition_seeds=0, faults="none")
    store = tmp_path / "store"
    settings = AssessSettings(
        "go1", controller_under_test("fails_above_1_rad_s"), card, store=str(store)
    )
    first = run_assess(settings, films=tmp_path / "films")
    assert first["push"]["broken"] == ["threw RuntimeError: too far"]
    assert [film["film"] for film in first["films"]] == ["film_survive.webp", "film_strict.webp"]
    kept = store.read_bytes()
    assert run_assess(settings)["push"] == first["push"] and store.read_bytes() == kept


def lines(path: Path) -> int:
    return path.read_bytes().count(b"\n") if path.exists() else 0


# The command.


def test_assess_command_writes_json_and_report(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    card = tmp_path / "card.toml"
    card.write_text(
        "directions = 1\nseeds = 1\ncondition_seeds = 1\nfaults = 'none'\n"
        "[[condition]]\nname = 'usual'\n"
        "[[condition]]\nname = 'steep'\nslope_deg = 24.0\nheadings_deg = [90.0]\n"
    )
    place, folder = tmp_path / "out.json", tmp_path / "report"
    words = ["assess", "--scenario", str(card), "--jobs", "1"]
    assert cli.main([*words, "--json", str(place), "--report", str(folder)]) == 0
    result = json.loads(place.read_text())
    push = result["push"]
    assert push["statistic"] == "1 seed"
    assert push["survive_percent_of_limit_p5"] >= push["strict_percent_of_limit_p5"] > 50.0
    row = push["tables"][0]["directions"][0]
    assert row["limit_ns"] == min(row["lip_ns"], row["quasi_static_ns"])
    assert row["survive"]["ns_per_kg"] == pytest.approx(
        row["survive"]["ns"] / result["pinned_pose"]["mass_kg"], rel=1e-5
    )
    usual, steep = (condition["stand"] for condition in result["conditions"])
    assert (
        usual["passed"] == steep["runs"] == 1 and steep["passed"] == 0 and result["faults"] is None
    )
    page = (folder / "index.html").read_text()
    assert "steep" in page and (folder / "pushes.png").is_file()
    assert result["films"] and all(film["caption"] in page for film in result["films"])
    assert "worst direction" in capsys.readouterr().out


def test_assess_command_refuses_invalid_arguments(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for words, complaint in (
        (["--controller", "nobody"], "module:callable"),
        (["--jobs", "0"], "jobs: got 0"),
        (["--deadline", "0"], "deadline: got 0"),
        (["--scenario", str(tmp_path / "none.toml")], "cannot read"),
        (["--scenario", "x.toml", "--quick"], "expected one of them"),
        (["--controller", "pd", "--gains", "x.toml"], "expected surefoot"),
        (["--json", str(tmp_path / "no" / "x.json")], "expected a file in a folder"),
    ):
        assert cli.main(["assess", "--quick"][: 1 if "--scenario" in words else 2] + words) == 2
        assert complaint in capsys.readouterr().err
