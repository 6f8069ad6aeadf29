# SPDX-License-Identifier: BSD-3-Clause
"""The assessment: its sweep, its card, its store, and controllers that are good, bad and none."""

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
from surefoot.assess import AssessSettings, Card, Condition, Contestant, read_card, run_assess
from surefoot.assess.card import standard_card
from surefoot.assess.contestant import BUILT_IN
from surefoot.assess.ground import plant_of
from surefoot.assess.push_limits import Limits
from surefoot.assess.push_run import Outcome, judge
from surefoot.assess.rollout import roll_out
from surefoot.assess.sweep import as_rows, first_level, from_rows, sweep
from surefoot.assess.unit import PushUnit, StandUnit, run_unit

LEVEL = Condition("level ground")
FEW = Card("few", directions=1, seeds=1, condition_directions=1, condition_seeds=1, faults="none")


def push_unit(degrees: float = 90.0) -> PushUnit:
    limit = Limits(surefoot.load_robot("go1")).of(LEVEL, degrees, 0.1, 0.0).own
    return PushUnit(LEVEL, degrees, 0.1, 0.0, 0, limit)


def contestant(name: str) -> Contestant:
    return Contestant(f"assess_contestants:{name}")


# The sweep.


@pytest.mark.parametrize("first", [10.0, 20.0, 60.0])
@pytest.mark.parametrize("survives", [*np.arange(0.0, 202.5, 2.5)])
def test_a_sweep_finds_the_last_level_below_which_all_pass(first: float, survives: float) -> None:
    strict = min(47.0, 0.8 * survives)
    done = sweep(lambda level: Outcome(level <= survives, level <= strict, 0.0, 0.0, 0.0), first)
    assert done.largest("survived") == survives
    assert strict - 2.5 < done.largest("strict") <= strict
    assert set(np.arange(first, min(survives + 20.0, 200.0), 20.0)) <= set(done.tried)
    # A sweep that begins above what passes goes up from nothing.
    missed = ((survives < first) + (strict < first)) * first / 5.0
    assert len(done.tried) <= max(0.0, survives - first) / 20.0 + 10 + missed


def test_a_sweep_is_as_fine_as_is_asked() -> None:
    done = sweep(lambda level: Outcome(level < 109.0, level < 71.0, 0.0, 0.0, 0.0), finest=5.0)
    assert (done.largest("survived"), done.largest("strict")) == (105.0, 70.0)
    assert all(level % 5.0 == 0.0 for level in done.tried)
    with pytest.raises(Error, match=r"finest: got 3 %, expected 5 or 2\.5"):
        sweep(lambda level: Outcome(True, True, 0.0, 0.0, 0.0), finest=3.0)


def test_seeds_take_turns_at_the_coarse_levels() -> None:
    passes, tried = Outcome(True, True, 0.0, 0.0, 0.0), set[float]()
    assert [first_level(turn) for turn in range(7)] == [10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 10.0]
    for turn in range(6):
        tried |= set(sweep(lambda level: passes, first_level(turn)).tried)
    assert tried == set(np.arange(10.0, 210.0, 10.0))


def test_a_sweep_stops_the_count_at_a_weak_push_that_fails_where_a_strong_one_passes() -> None:
    done = sweep(lambda level: Outcome(level < 120.0, not 38.0 < level < 42.0, 0.0, 0.0, 0.0), 20.0)
    assert done.tried[100.0].strict
    assert done.largest("strict") == 37.5


def test_a_sweep_of_a_robot_that_falls_by_itself_is_nothing() -> None:
    done = sweep(lambda level: Outcome(False, False, 0.0, None, None))
    assert done.largest("survived") == done.largest("strict") == 0.0
    assert from_rows(json.loads(json.dumps(as_rows(done)))).largest("survived") == 0.0


# The card.


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
def test_a_scenario_that_makes_no_sense_is_refused(tmp_path: Path, text: str, words: str) -> None:
    file = tmp_path / "card.toml"
    file.write_text(text)
    with pytest.raises(Error) as caught:
        read_card(file)
    assert words in str(caught.value) and "card.toml" in str(caught.value)


def test_the_cards_that_ship_have_what_the_protocol_asks_for() -> None:
    full, quick = standard_card("full"), standard_card("quick")
    assert full.directions == quick.directions == 16 and full.seeds == 20 and quick.seeds == 3
    assert full.lengths_s == (0.02, 0.1, 0.5) and set(full.heights_m) == {0.0, 0.1, -0.1}
    assert quick.lengths_s == (0.1,) and quick.heights_m == (0.0,)
    assert {c.friction for c in full.conditions} >= {0.2, 0.4, 0.6, 0.8, 1.0}
    assert [c.name for c in quick.conditions] == [c.name for c in full.conditions]
    assert not any(c.pushes for c in quick.conditions)


# Contestants.


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("throws", "threw ValueError: no idea"),
        ("leaves", "threw SystemExit: 3"),
        ("cancels", "threw CancelledError"),
        ("nan", "returned tau = nan for motor 3"),
        ("infinite", "returned Kd = inf for motor 11"),
        ("wrong_shape", "returned ndarray of shape (11,), expected a LowCmd"),
        ("nothing", "returned NoneType, expected a LowCmd"),
        ("not_callable", "making it gave int"),
        ("mapping", "making it gave dict"),
        ("no_factory", "making it threw RuntimeError: cannot be made"),
    ],
)
def test_a_controller_that_is_none_is_marked_with_the_reason(name: str, words: str) -> None:
    found = run_unit(push_unit(), "go1", contestant(name))
    assert words in found["broken"]
    assert not any(survived for _, survived, *_ in found["rows"])


def test_a_controller_that_breaks_under_hard_pushes_has_survived_the_others() -> None:
    found = run_unit(push_unit(), "go1", contestant("gives_up"))
    assert found["broken"] == "threw RuntimeError: too far"
    done = from_rows(json.loads(json.dumps(found["rows"])))
    assert 10.0 <= done.largest("survived") <= 100.0
    assert all(o.survived == (o.foot_mm is not None) for o in done.tried.values())


def test_a_robot_that_falls_before_its_push_has_survived_nothing() -> None:
    rows = run_unit(push_unit(), "go1", contestant("limp"))["rows"]
    assert from_rows(rows).largest("survived") == 0.0


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("nobody", "expected surefoot, pd, force_qp or module:callable"),
        ("assess_contestants:missing", "has no attribute 'missing'"),
        ("assess_contestants:number", "got int, expected a callable"),
        ("no_such_module:x", "ModuleNotFoundError"),
    ],
)
def test_a_controller_that_is_not_there_is_refused_at_once(name: str, words: str) -> None:
    with pytest.raises(Error) as caught:
        AssessSettings("go1", Contestant(name))
    assert words in str(caught.value)


def test_a_module_that_does_not_come_to_its_end_is_refused_in_time() -> None:
    with pytest.raises(Error, match=r"its import took longer than 0\.2 s"):
        AssessSettings("go1", Contestant("assess_sleeper:make"), deadline=0.2)


@pytest.mark.parametrize(
    ("what", "words"),
    [
        ({"factory": surefoot.StandController}, "got a factory called 'surefoot'"),
        ({"name": "pd", "gains": {"edge_tilt": 0.1}}, "'pd': got gains, which are for surefoot"),
        ({"gains": {"edge_tlit": 0.1}}, "unknown gain: got 'edge_tlit'"),
        ({"name": None}, "controller: got None"),
    ],
)
def test_a_contestant_that_would_be_taken_for_another_is_refused(
    what: dict[str, Any], words: str
) -> None:
    with pytest.raises(Error, match=words):
        Contestant(**what)


@pytest.mark.parametrize(
    ("what", "words"),
    [
        ({"jobs": 1.5}, r"jobs: got 1\.5, expected a whole number 1 \.\. 256"),
        ({"jobs": "2"}, "jobs: got '2'"),
        ({"deadline": "2"}, "deadline: got '2', expected a number"),
        ({"card": "quick"}, "card: got 'quick', expected a Card"),
        ({"contestant": "pd"}, "contestant: got 'pd', expected a Contestant"),
    ],
)
def test_settings_that_make_no_sense_are_refused(what: dict[str, Any], words: str) -> None:
    with pytest.raises(Error, match=words):
        AssessSettings("go1", **what)


def test_a_factory_that_cannot_travel_is_refused_at_once() -> None:
    with pytest.raises(Error, match="cannot be handed to another process"):
        AssessSettings("go1", Contestant("mine", factory=lambda robot: None))


def test_any_callable_gets_the_same_run_as_the_built_in() -> None:
    unit = push_unit()
    built_in = unit.play("go1", Contestant("surefoot"), 60.0)
    for other in (contestant("good"), Contestant("mine", factory=surefoot.StandController)):
        assert (unit.play("go1", other, 60.0).base == built_in.base).all()
    assert judge(built_in, LEVEL.quiet_s, 0.1).strict


@pytest.mark.parametrize("name", BUILT_IN)
@pytest.mark.parametrize("robot", ["go1", "b1"])
def test_every_built_in_stands_still_and_takes_a_push(robot: str, name: str) -> None:
    stood = run_unit(StandUnit(LEVEL, 0.0, 1), robot, Contestant(name))
    assert stood["passed"] and stood["foot_mm"] < 2.0
    limit = Limits(surefoot.load_robot(robot)).of(LEVEL, 90.0, 0.1, 0.0).own
    unit = PushUnit(LEVEL, 90.0, 0.1, 0.0, 1, limit)
    assert judge(unit.play(robot, Contestant(name), 60.0), LEVEL.quiet_s, 0.1).survived


# The run.


def test_lost_reports_come_again_and_lost_commands_stay_in_force() -> None:
    condition = Condition("lossy", loss_percent=30.0)
    plant = plant_of("go1", condition)
    plant.renew(4)
    ticks: list[int] = []
    controller = surefoot.StandController(plant.robot)

    def act(state: surefoot.LowState) -> surefoot.LowCmd:
        ticks.append(state.tick)
        return controller.update(state)

    track = roll_out(plant, condition, act, 0.6)
    steps = [b - a for a, b in pairwise(ticks)]
    assert track.fell is None and len(track.base) == 301
    assert steps.count(0) == pytest.approx(0.3 * 300, rel=0.35) and min(steps) == 0
    assert ticks[0] == 0 and ticks[-1] <= 2 * 299


def test_a_run_can_be_had_again_from_the_same_plant() -> None:
    unit = push_unit(0.0)
    first = unit.play("go1", Contestant(), 50.0)
    push_unit(180.0).play("go1", Contestant(), 80.0)
    again = unit.play("go1", Contestant(), 50.0)
    assert (first.base == again.base).all() and (first.feet == again.feet).all()


# The store.


def test_an_assessment_that_was_killed_goes_on(tmp_path: Path) -> None:
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
    alone = run_assess(AssessSettings("go1", Contestant("pd"), read_card(card)))
    resumed = json.loads(place.read_text())
    assert resumed["push"] == alone["push"]


def test_a_sweep_that_broke_its_controller_is_done_and_can_be_filmed(tmp_path: Path) -> None:
    card = Card("few", directions=1, seeds=1, condition_seeds=0, faults="none")
    store = tmp_path / "store"
    settings = AssessSettings("go1", contestant("gives_up"), card, store=str(store))
    first = run_assess(settings, films=tmp_path / "films")
    assert first["push"]["broken"] == ["threw RuntimeError: too far"]
    assert [film["film"] for film in first["films"]] == ["film_survive.webp", "film_strict.webp"]
    kept = store.read_bytes()
    assert run_assess(settings)["push"] == first["push"] and store.read_bytes() == kept


def lines(path: Path) -> int:
    return path.read_bytes().count(b"\n") if path.exists() else 0


# The command.


def test_the_command_writes_json_and_report(
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


def test_the_command_refuses(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
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
